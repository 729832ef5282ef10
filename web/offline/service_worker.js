// Keeps the page, so that it opens without a network after one visit. The build writes `build` before this text
// (assets/offline_files.py): { id, files: { NAME: SHA-256 } }, with all files of the page's folder.
//
// - A kept file is found by its hash: versions share equal files, and nothing is fetched twice.
// - An open page keeps its version, even when another tab has adopted a newer one, so that windows and workers that it
//   loads later fit its program.
// - A new version is fetched whole, and checked, before any of it is used.
const scope = new URL(self.registration.scope);
const address = (text) => new URL(text, scope).href;
const place = (name, hash) => address(`${name}?sha256=${hash}`);
const list = (id) => address(`?files=${id}`);
const notes = address("?notes");
const asJson = (value) => new Response(JSON.stringify(value));
const shelf = `evenlift ${scope.pathname}`;
const open = () => caches.open(shelf);

// --- A new version -------------------------------------------------------------------------------

async function hashOf(bytes) {
  const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return [...digest].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}

// With the server's headers, which include the content security policy, but without content encoding and length.
async function fetchChecked(name, hash) {
  const answer = await fetch(address(name), { cache: "no-cache" });
  if (!answer.ok) throw new Error(`${name}: ${answer.status}`);
  const bytes = await answer.arrayBuffer();
  if ((await hashOf(bytes)) !== hash) throw new Error(`${name} is not the file that was built`);
  const headers = new Headers(answer.headers);
  for (const header of ["content-encoding", "content-length", "transfer-encoding"]) headers.delete(header);
  return new Response(bytes, { headers });
}

async function keepAll() {
  const cache = await open();
  await Promise.all(
    Object.entries(build.files).map(async ([name, hash]) => {
      const at = place(name, hash);
      if (!(await cache.match(at))) await cache.put(at, await fetchChecked(name, hash));
    }),
  );
  await cache.put(list(build.id), asJson(build.files));
}

// --- Who began with which version ----------------------------------------------------------------

// { current, began: { CLIENT: BUILD } }. Kept, since the browser ends an idle worker, and read once.
let known;
async function readNotes() {
  const kept = await (await open()).match(notes);
  return kept ? kept.json() : { current: build.id, began: {} };
}

async function write(next) {
  known = Promise.resolve(next);
  await (await open()).put(notes, asJson(next));
}

// New pages open this version, open pages keep theirs; files that no page needs are deleted.
async function takeOver() {
  const { current, began } = await readNotes();
  const ids = (await self.clients.matchAll({ type: "all" })).map(({ id }) => id);
  const next = { current: build.id, began: {} };
  for (const id of ids) if ((began[id] ?? current) !== build.id) next.began[id] = began[id] ?? current;
  await write(next);
  await removeOld([build.id, ...Object.values(next.began)]);
  await self.clients.claim();
}

// At each opening of a page, since pages with an older version close eventually.
async function tidy() {
  const all = await known;
  if (Object.keys(all.began).length === 0) return;
  const ids = new Set((await self.clients.matchAll({ type: "all" })).map(({ id }) => id));
  for (const id of Object.keys(all.began)) if (!ids.has(id)) delete all.began[id];
  await write(all);
  await removeOld([build.id, ...Object.values(all.began)]);
}

async function filesOf(id) {
  if (id === build.id) return build.files;
  return (await (await open()).match(list(id)))?.json();
}

async function removeOld(builds) {
  const cache = await open();
  const needed = new Set([notes, ...builds.map(list)]);
  for (const files of await Promise.all(builds.map(filesOf))) {
    for (const [name, hash] of Object.entries(files ?? {})) needed.add(place(name, hash));
  }
  await Promise.all((await cache.keys()).filter(({ url }) => !needed.has(url)).map((key) => cache.delete(key)));
}

// A host without this page, or with another one here, reports so; otherwise the kept page would hide that for ever.
async function leaveIfGone() {
  const { status } = await fetch(address("service_worker.js"), { method: "HEAD", cache: "no-store" });
  if (status !== 404 && status !== 410) return;
  await self.registration.unregister();
  await caches.delete(shelf);
}

// --- Answers -------------------------------------------------------------------------------------

// Undefined for a name that is not in the page's folder.
function nameOf({ method, url }) {
  const { origin, pathname } = new URL(url);
  if (method !== "GET" || origin !== scope.origin || !pathname.startsWith(scope.pathname)) return undefined;
  const name = pathname.slice(scope.pathname.length) || "index.html";
  return name.includes("/") ? undefined : name;
}

async function answer({ request, clientId, resultingClientId }, name) {
  known ??= readNotes();
  const all = await known;
  const older = request.mode === "navigate" ? undefined : all.began[clientId];
  if (older && resultingClientId) {
    // a worker loads the files that fit the page that started it
    all.began[resultingClientId] = older;
    await write(all);
  }
  const files = await filesOf(older ?? build.id);
  const kept = files?.[name] && (await (await open()).match(place(name, files[name])));
  return kept ?? fetch(request);
}

self.addEventListener("install", (event) => event.waitUntil(keepAll()));
self.addEventListener("activate", (event) => event.waitUntil(takeOver()));
self.addEventListener("message", ({ data }) => data === "take over" && self.skipWaiting());
self.addEventListener("fetch", (event) => {
  const name = nameOf(event.request);
  if (name === undefined) return;
  const given = answer(event, name);
  event.respondWith(given);
  if (event.request.mode === "navigate")
    event.waitUntil(
      given.then(
        () => Promise.allSettled([tidy(), leaveIfGone()]),
        () => {},
      ),
    );
});
