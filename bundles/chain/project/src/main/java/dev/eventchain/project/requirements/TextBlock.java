package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.SourceText;
import java.util.List;
import java.util.Map;

/** A block of a text in Markdown or reStructuredText. */
sealed interface TextBlock {

  /** Returns the number of its first line, from 1. */
  int line();

  /**
   * A heading.
   *
   * @param level 1 for the highest
   */
  record Heading(int line, int level, String text) implements TextBlock {}

  /**
   * A paragraph, or an entry of a list without its mark.
   *
   * @param indent the number of blanks in front of it
   * @param isEntry whether it has a mark of a list
   */
  record Lines(int line, int indent, boolean isEntry, List<String> lines) implements TextBlock {}

  /** A table with a header. */
  record Table(int line, List<String> header, List<Row> rows) implements TextBlock {}

  /** A row of a table. */
  record Row(int line, List<String> cells) {}

  /** A directive of reStructuredText, such as a need of sphinx-needs. */
  record Directive(int line, String name, String title, Map<String, String> options, String content)
      implements TextBlock {}

  /** The blocks of another file, which a text takes in. */
  record Included(int line, SourceText source, List<TextBlock> blocks) implements TextBlock {}
}
