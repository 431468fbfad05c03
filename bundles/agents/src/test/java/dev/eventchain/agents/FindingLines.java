package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertFalse;

import dev.eventchain.agents.prompt.FindingsText;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.fixtures.ExpectedFile;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Text form of findings in these tests. */
public final class FindingLines {
  /** Mentions of files and options. */
  public static final Pattern FILES =
      Pattern.compile(
          "\\.(json|yaml|md|xmi|ecore|msg|py)\\b|(^| )--[a-z]|(?<!['`])\\b[Ff]iles?\\b(?!['`])");

  private FindingLines() {}

  /**
   * Compares the findings about an answer with the expected ones in the file next to it. Texts for
   * a language model may mention its own names, but no files and options.
   */
  public static void check(Path answer, Collection<Diagnostic> found) throws IOException {
    ExpectedFile.check(ExpectedFile.beside(answer), of(found));
    String file = found.stream().map(each -> each.location().file()).findFirst().orElse("");
    String told = FindingsText.of(file, List.copyOf(found));
    String words =
        told.lines()
            .filter(line -> !line.startsWith("   > "))
            .map(line -> line.replaceAll("'[\\w./]*'", "''"))
            .collect(Collectors.joining("\n"));
    assertFalse(FILES.matcher(words).find(), () -> answer + ":\n" + told);
  }

  /** Returns findings in a form that is easy to compare with the input. */
  public static String of(Collection<Diagnostic> diagnostics) {
    StringBuilder out = new StringBuilder();
    for (Diagnostic diagnostic : diagnostics) {
      out.append(diagnostic.severity()).append(' ');
      out.append(diagnostic.location().line()).append(':').append(diagnostic.location().column());
      out.append(' ').append(diagnostic.location().element()).append(' ').append(diagnostic.id());
      out.append(": ").append(diagnostic.message()).append('\n');
    }
    return out.toString();
  }
}
