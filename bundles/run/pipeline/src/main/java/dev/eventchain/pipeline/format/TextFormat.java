package dev.eventchain.pipeline.format;

import dev.eventchain.constraints.editing.RuleFormatter;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.YamlFormatter;
import dev.eventchain.m2t.editing.TemplateFormatter;
import java.nio.file.Path;
import java.util.Optional;

/** Kind of text that can be formatted. */
public enum TextFormat {
  /** Complete OCL. */
  RULES,
  /** Templates of text. */
  TEMPLATE,
  /** YAML, which may be anybody's outside of projects. */
  YAML;

  /** Returns the kind of a file by its name; empty if it is none of them. */
  public static Optional<TextFormat> of(Path file) {
    String name = String.valueOf(file.getFileName());
    if (name.endsWith(".ocl")) {
      return Optional.of(RULES);
    } else if (name.endsWith(".mtl")) {
      return Optional.of(TEMPLATE);
    }
    return name.matches(".*\\.ya?ml") ? Optional.of(YAML) : Optional.empty();
  }

  /**
   * Formats a text without a byte order mark.
   *
   * @param columns the width of one level of indentation, at least 1
   * @param spaces false if constraints are indented by tabs, which YAML never is
   * @return empty if it is better left as it is
   */
  public Optional<String> format(String text, int columns, boolean spaces) {
    return switch (this) {
      case RULES -> RuleFormatter.format(text, spaces ? " ".repeat(columns) : "\t");
      case TEMPLATE -> TemplateFormatter.format(text);
      case YAML -> YamlFormatter.format(text, columns);
    };
  }

  /** Returns the syntax error that keeps a text from being formatted; empty if there is none. */
  Optional<Diagnostic> syntaxError(SourceText source) {
    return switch (this) {
      case RULES -> RuleFormatter.syntaxError(source);
      case TEMPLATE -> TemplateFormatter.syntaxError(source);
      case YAML -> YamlFormatter.syntaxError(source, FormatRules.SYNTAX);
    };
  }
}
