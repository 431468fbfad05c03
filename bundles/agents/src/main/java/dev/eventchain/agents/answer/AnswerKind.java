package dev.eventchain.agents.answer;

import java.util.regex.Pattern;

/** What an answer is expected to hold, and how that is told from the talk around it. */
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

  /** What people and models call it. */
  public String description() {
    return description;
  }

  /** Whether a fenced block with this language tag may hold it. */
  boolean isLanguage(String tag) {
    return languages.matcher(tag).matches();
  }

  /** Whether a line may be its first one. */
  boolean startsWith(String line) {
    return start.matcher(line).find();
  }
}
