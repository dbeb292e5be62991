import { expect, test } from "@playwright/test";

// As it is visited.
test.use({ serviceWorkers: "allow" });

test("the page loads below a sub-path, from its own host only, without a complaint", async ({ page, baseURL }) => {
  const complaints: string[] = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("requestfailed", (request) => complaints.push(`failed: ${request.url()}`));
  page.on("request", (request) => {
    const own = request.url().startsWith(baseURL!) || /^(data|blob):/.test(request.url());
    if (!own) complaints.push(`foreign: ${request.url()}`);
  });
  page.on("response", (response) => {
    if (response.status() >= 400) complaints.push(`${response.status()}: ${response.url()}`);
  });
  const wasm = page.waitForResponse((response) => response.url().endsWith(".wasm"));
  await page.goto("./");
  expect((await wasm).headers()["content-type"]).toBe("application/wasm");
  await page.waitForLoadState("networkidle");
  expect(complaints).toEqual([]);
});
