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

/** How these tests write findings down. */
public final class FindingLines {
  /** What speaks of files and options. */
  public static final Pattern FILES =
      Pattern.compile(
          "\\.(json|yaml|md|xmi|ecore|msg|py)\\b|(^| )--[a-z]|(?<!['`])\\b[Ff]iles?\\b(?!['`])");

  private FindingLines() {}

  /**
   * Compares what was found in an answer with what the file next to it expects. A language model is
   * told it in words of its answer: names of its own may be there, but no files and options.
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

  /** Findings in a form that is easy to read next to the input. */
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
