// Shows the rows of the page "Keys by task" that contain all words of the filter, and the sections that have such rows.
(() => {
  const box = document.getElementById("key-filter");
  const count = document.getElementById("key-count");
  const rows = [...document.querySelectorAll("table.keys tbody tr")];
  const texts = rows.map((row) => row.textContent.toLowerCase());
  const sections = [...document.querySelectorAll("section section")];
  const show = () => {
    const words = box.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    rows.forEach((row, i) => {
      row.hidden = !words.every((word) => texts[i].includes(word));
      shown += row.hidden ? 0 : 1;
    });
    for (const section of sections) section.hidden = !section.querySelector("tbody tr:not([hidden])");
    count.textContent = words.length ? `${shown} of ${rows.length} keys` : `${rows.length} keys`;
  };
  box.addEventListener("input", show);
  show();
})();
