// Which signals of a catalogue the design was offered, and why.

function retrievedSection() {
  const entries = records(data.retrieved);
  if (entries.length === 0) {
    return null;
  }
  const columns = [{ name: "Signals", row: true, width: "42%" }, { name: "Number", number: true, width: "8%" },
    { name: "Score", number: true, width: "8%" }, { name: "Because of", width: "10%", plain: true }, { name: "Meaning", width: "32%", plain: true }];
  const rows = entries.map((entry) => ({ cells: [code(text(entry.signals)), whole(entry.number), figure(entry.score, 3),
    entry.pinned === true ? "pinned" : text(entry.because), text(entry.meaning)] }));
  return section("retrieved", "Signals offered to the design", "Found in the catalogue by the words of the requirements and of existing components. A signal that is missing can be pinned in eventchain.yaml.",
    table("Signals of the catalogue, best first", columns, rows, { stack: true }));
}
