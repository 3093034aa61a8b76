/** The token that opens the server, taken out of the address: an address is shown, shared and kept in histories. */

const KEY = "barchan-token";

/** The token of the address, or the one that this tab came with before it was loaded again; empty where there is none. */
export function takeToken(): string {
  const address = new URL(location.href);
  const given = address.searchParams.get("token");
  if (given === null) return stored();
  address.searchParams.delete("token");
  try {
    sessionStorage.setItem(KEY, given);
    history.replaceState(history.state, "", address);
  } catch {
    // without storage the address stays the only place that holds it
  }
  return given;
}

function stored(): string {
  try {
    return sessionStorage.getItem(KEY) ?? "";
  } catch {
    return "";
  }
}
