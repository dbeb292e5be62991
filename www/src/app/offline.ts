/** The full page works without a network after its first visit. */
export async function workOffline(): Promise<void> {
  // Development serves no such script, and some pages may not have one.
  if (!import.meta.env.PROD || !("serviceWorker" in navigator)) return;
  try {
    await navigator.serviceWorker.register(new URL("./sw.js", document.baseURI));
  } catch {
    // Private windows and insecure hosts refuse; the page works as before.
  }
}
