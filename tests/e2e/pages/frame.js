// Embeds the bare frame from another origin and talks with it.
const frame = document.createElement("iframe");
frame.title = "Playground";
frame.width = "720";
frame.height = "420";
const hash = new URLSearchParams(location.search).get("hash") ?? "layout=single&controls=minimal";
frame.src = `http://localhost:${location.port}/sub/path/embed.html#${hash}`;
window.heard = [];
addEventListener("message", ({ data, origin }) => {
  if (origin !== new URL(frame.src).origin) return;
  window.heard.push(data);
  if (data.type === "parkade:height") frame.height = data.height;
});
let last = 0;
window.ask = (name, rest = {}) => new Promise((done) => {
  const id = ++last;
  addEventListener("message", function listen({ data }) {
    if (data?.type !== "parkade:reply" || data.id !== id) return;
    removeEventListener("message", listen);
    done(data);
  });
  frame.contentWindow.postMessage({ type: `parkade:${name}`, id, ...rest }, new URL(frame.src).origin);
});
document.body.append(frame);
