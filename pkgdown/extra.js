// Fill "On this page" with links to the headings.
const nav = document.getElementById("toc");
const headings = [...document.querySelectorAll("main h2, main h3")];
if (nav && headings.length > 1) {
  const list = nav.appendChild(document.createElement("ul"));
  for (const heading of headings) {
    const id = heading.id || heading.closest("[id]").id;
    if (!id || id === "main") continue;
    const link = document.createElement("a");
    link.href = `#${id}`;
    // Leave out the anchor of the heading.
    link.textContent = [...heading.childNodes]
      .filter((node) => !node.classList?.contains("anchor"))
      .map((node) => node.textContent).join("").trim();
    const item = list.appendChild(document.createElement("li"));
    item.className = `below-${heading.tagName.toLowerCase()}`;
    item.append(link);
  }
} else if (nav) nav.remove();

// Replace a picture by its live gear.
for (const picture of document.querySelectorAll("img[data-live]")) {
  const live = document.createElement("iframe");
  live.className = "live";
  live.loading = "lazy";
  live.src = `../live/${picture.dataset.live}.html`;
  live.title = `${picture.alt}: sliders change it`;
  picture.replaceWith(live);
}
