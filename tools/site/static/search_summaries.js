// The search shows a part of each page that it finds, which it fetches. Browsers fetch nothing from file://, so the texts
// come with the page of the search.
window.fetch = (address) => {
  const name = decodeURIComponent(new URL(address, document.baseURI).href.slice(new URL(".", document.baseURI).href.length));
  const main = document.createElement("div");
  main.setAttribute("role", "main");
  main.textContent = pageTexts[name] ?? "";
  return Promise.resolve(new Response(main.outerHTML));
};
