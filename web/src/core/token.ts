/** The token that opens the server, taken out of the address: an address is shown, shared and kept in histories. */

/** The keys of an address that hold a token: that of the window that commands, and that of those that watch. */
const COMMANDS = "token";
const WATCHES = "watch";
const KEY = "barchan-token";
const KIND = "barchan-token-kind";

export interface Access {
  /** Empty where the page has none. */
  token: string;
  /** Whether it lets the page watch only. */
  watching: boolean;
}

/** What the address holds, or what this tab came with before it was loaded again. */
export function takeAccess(): Access {
  const address = new URL(location.href);
  const kind = [COMMANDS, WATCHES].find((one) => address.searchParams.has(one));
  if (kind === undefined) return { token: stored(KEY), watching: stored(KIND) === WATCHES };
  const token = address.searchParams.get(kind)!;
  address.searchParams.delete(COMMANDS);
  address.searchParams.delete(WATCHES);
  try {
    sessionStorage.setItem(KEY, token);
    sessionStorage.setItem(KIND, kind);
    history.replaceState(history.state, "", address);
  } catch {
    // without storage the address stays the only place that holds it
  }
  return { token, watching: kind === WATCHES };
}

/** The part of an address that lets its page watch. */
export function watchQuery(token: string): string {
  return `?${WATCHES}=${encodeURIComponent(token)}`;
}

/** The part of an address that somebody gave: a whole address, or only the token of the window that commands. */
export function queryIn(text: string): string {
  const [, kind, token] = /[?&](token|watch)=([^&#\s]+)/.exec(text) ?? [];
  return kind ? `?${kind}=${token}` : `?${COMMANDS}=${encodeURIComponent(text.trim())}`;
}

function stored(key: string): string {
  try {
    return sessionStorage.getItem(key) ?? "";
  } catch {
    return "";
  }
}
