package dev.eventchain.agents.prompt;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Text of findings for a language model: numbered, with place, source line and hint. */
public final class FindingsText {
  // Enough to work on; the rest usually has the same causes, or comes back in the next round.
  private static final int MOST = 25;

  private static final Pattern CLAUSE_END = Pattern.compile("(?<=[.;?]) ");
  private static final Pattern ABOUT_FILES =
      Pattern.compile(
          "(^| )--[a-z]|PACKAGE/msg/NAME|Looked for among|\\b[Ff](iles?|olders?)\\b"
              + "|\\.(json|yaml|md|xmi|ecore|msg|py|ocl)\\b");

  /** Mentions of the file; text in quotes is a name. */
  private static final Pattern THE_FILE = Pattern.compile("\\b([Tt]h)(?:e|is) file(?!['`])\\b");

  private static final Pattern A_FILE =
      Pattern.compile("(?<!['`./])\\bfile(s?)\\b(?!['`]|[.][a-z])");

  private FindingsText() {}

  /**
   * Returns the text of findings; those about an answer include its source line.
   *
   * @param file the name of the file that the answer becomes
   */
  public static String of(String file, List<Diagnostic> findings) {
    StringBuilder out = new StringBuilder();
    for (int i = 0; i < Math.min(findings.size(), MOST); i++) {
      append(out, i + 1, findings.get(i), findings.get(i).location().file().equals(file));
    }
    if (findings.size() > MOST) {
      out.append(String.format(Locale.ROOT, "And %d more.\n", findings.size() - MOST));
    }
    return out.toString();
  }

  private static void append(
      StringBuilder out, int number, Diagnostic finding, boolean ofTheAnswer) {
    SourceLocation place = finding.location();
    out.append(number).append(". ");
    if (place.line() > 0 && ofTheAnswer) {
      out.append("Line ").append(place.line()).append(", column ").append(place.column());
      out.append(place.element().isEmpty() ? ": " : ", at " + place.element() + ": ");
    } else if (!place.element().isEmpty() && ofTheAnswer) {
      out.append("At ").append(place.element()).append(": ");
    }
    out.append(ofTheAnswer(finding.message()));
    if (!finding.rule().isEmpty()) {
      out.append(" (").append(finding.rule()).append(')');
    }
    out.append(" [").append(finding.id()).append("]\n");
    if (!place.excerpt().isBlank() && ofTheAnswer) {
      out.append("   > ").append(place.excerpt().strip()).append('\n');
    }
    String hint = aboutTheAnswer(finding.hint());
    if (!hint.isEmpty()) {
      out.append("   ").append(hint).append('\n');
    }
  }

  /** Rewords a text about a file as one about the answer, which the model sees. */
  private static String ofTheAnswer(String text) {
    String answer = THE_FILE.matcher(text).replaceAll("$1e answer");
    return A_FILE.matcher(answer).replaceAll("document$1");
  }

  /**
   * Returns a hint without sentences about files and options: the model sees and changes its answer
   * only.
   */
  private static String aboutTheAnswer(String hint) {
    String kept =
        CLAUSE_END
            .splitAsStream(ofTheAnswer(hint))
            .filter(clause -> !ABOUT_FILES.matcher(clause).find())
            .collect(Collectors.joining(" "));
    return kept.endsWith(";") ? kept.substring(0, kept.length() - 1) + "." : kept;
  }
}
