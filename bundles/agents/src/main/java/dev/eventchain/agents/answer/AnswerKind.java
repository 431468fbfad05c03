package dev.eventchain.agents.answer;

import java.util.regex.Pattern;

/** Kinds of artefacts in answers, and their recognition in the surrounding text. */
public enum AnswerKind {
  /** A JSON array or object. */
  JSON("JSON", "json|json5|jsonc|javascript|js", "^\\s*[\\[{]"),
  /** A Python module. */
  PYTHON(
      "Python module",
      "python|py|python3",
      "^(import |from |class |def |@|#!|\"\"\"|'''|[A-Z_]+\\s*=)"),
  /** A Complete OCL document. */
  OCL("OCL document", "ocl", "^\\s*(--|context |package |import )");

  private final String description;
  private final Pattern languages;
  private final Pattern start;

  AnswerKind(String description, String languages, String start) {
    this.description = description;
    this.languages = Pattern.compile(languages);
    this.start = Pattern.compile(start);
  }

  /** Returns the name of the kind in messages. */
  public String description() {
    return description;
  }

  /** Returns whether a fenced block with this language tag may hold the artefact. */
  boolean isLanguage(String tag) {
    return languages.matcher(tag).matches();
  }

  /** Returns whether a line may be the first one of the artefact. */
  boolean startsWith(String line) {
    return start.matcher(line).find();
  }
}
