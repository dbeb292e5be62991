// Keeps the page's files for visits without a network. FILES and VERSION are put in by the build.
const FILES = [];
const VERSION = "";
const CACHE = `parkade-${VERSION}`;

self.addEventListener("install", (event) => {
  const requests = FILES.map((file) => new Request(file, { cache: "no-cache" }));
  event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(requests)));
});

// A new version takes over when the last tab of the old one is closed: its files belong together.
self.addEventListener("activate", (event) => {
  const isOld = (name) => name.startsWith("parkade-") && name !== CACHE;
  event.waitUntil(
    caches.keys().then((names) => Promise.all(names.filter(isOld).map((name) => caches.delete(name)))),
  );
});

self.addEventListener("fetch", (event) => {
  const { request } = event, url = new URL(request.url), home = new URL("./", self.location.href);
  if (request.method !== "GET" || !url.href.startsWith(home.href)) return;
  const file = url.href.slice(home.href.length).replace(/[?#].*$/, "") || "index.html";
  if (!FILES.includes(file)) return;
  event.respondWith(caches.open(CACHE).then(async (cache) => (await cache.match(file)) ?? fetch(request)));
});
