// Says what the playground found, again after every edit.
const playground = document.getElementById("compared");
playground.addEventListener("plan-complete", ({ detail: { results } }) => {
  const lengths = Object.values(results)
    .filter((plan) => plan?.outcome === "found")
    .map((plan) => plan.metrics.length);
  document.getElementById("answer").textContent = lengths.length > 0 ? Math.min(...lengths).toFixed(2) : "none";
});
