import { underWay } from "../page/under_way.js";

// The page's own data files, each fetched once, when first asked for; a failure may be tried again.
const fetched = new Map();

export function fetchJson(name) {
  if (!fetched.has(name)) {
    const coming = ask(new URL(name, import.meta.url)).then((answer) => answer.json());
    coming.catch(() => fetched.delete(name));
    fetched.set(name, coming);
  }
  return fetched.get(name);
}

// Rejects with an Error that says why in words.
export async function ask(url, options) {
  let answer;
  try {
    answer = await underWay(fetch(url, options));
  } catch {
    throw new Error("the server cannot be reached");
  }
  if (!answer.ok) throw new Error(answer.status === 404 ? "the server does not have it" : `the server answers ${answer.status}`);
  return answer;
}
