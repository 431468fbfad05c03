package dev.eventchain.constraints.editing;

import dev.eventchain.constraints.document.RuleDocument;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.TextLines;
import dev.eventchain.ocl.text.Tokens;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * One version of a document, read without metamodels.
 *
 * @param sections its clauses by their first words
 * @param document its clauses as far as they are complete
 */
record RuleText(
    Path file, SourceText source, TextLines lines, List<Section> sections, RuleDocument document) {

  static RuleText of(Path file, SourceText source) {
    return new RuleText(
        file,
        source,
        new TextLines(source.text()),
        Section.in(new Tokens(source.text())),
        RuleDocument.read(source, new ArrayList<>()));
  }

  /** Returns the definitions. */
  List<RuleDocument.Clause> definitions() {
    return document.clauses().stream().filter(RuleDocument.Clause::definition).toList();
  }

  /** Returns the index of the section at an offset or before it; -1 if there is none. */
  int sectionAt(int offset) {
    int found = -1;
    while (found + 1 < sections.size() && sections.get(found + 1).start() <= offset) {
      found++;
    }
    return found;
  }

  /** Returns the offset at which the next section starts. */
  int limit(int section) {
    return section + 1 < sections.size()
        ? sections.get(section + 1).start()
        : source.text().length();
  }
}
