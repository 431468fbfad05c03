package dev.eventchain.documents;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;
import java.util.Optional;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

/** Tests changes of files in the unified format, by the program that people apply them with. */
class UnifiedDiffTest {

  private record Change(Optional<String> before, String after) {}

  /** Many changes in one diff each, since each of them takes a process. */
  @Property(tries = 20)
  void gitMakesTheTextThatTheDiffIsOf(@ForAll("changes") List<Change> changes) throws Exception {
    Path folder = Files.createTempDirectory("unified-diff");
    try {
      StringBuilder diff = new StringBuilder();
      for (int i = 0; i < changes.size(); i++) {
        Change change = changes.get(i);
        if (change.before().isPresent()) {
          Files.writeString(folder.resolve(name(i)), change.before().get());
        }
        diff.append(UnifiedDiff.of(name(i), change.before(), change.after()));
      }
      Path file = Files.writeString(folder.resolve("all.diff"), diff);
      assertEquals("", diff.isEmpty() ? "" : apply(folder, file));
      for (int i = 0; i < changes.size(); i++) {
        assertEquals(text(changes.get(i).after()), text(textOf(folder.resolve(name(i)))));
      }
    } finally {
      delete(folder);
    }
  }

  @Property(tries = 20)
  void theTextThatTheDiffIsOfIsMadeAgain(@ForAll("changes") List<Change> changes) {
    for (Change change : changes) {
      String before = change.before().orElse("");
      String diff = UnifiedDiff.of("x", change.before(), change.after());
      assertEquals(Optional.of(change.after()), UnifiedDiff.apply(diff, before), diff);
    }
  }

  @Test
  void aDiffOfAnotherTextIsNotApplied() {
    String diff = UnifiedDiff.of("a b.txt", Optional.of("a\nb\nc\n"), "a\nB\nc\n");
    assertEquals(Optional.of("a b.txt"), UnifiedDiff.file(diff));
    assertEquals(Optional.empty(), UnifiedDiff.apply(diff, "a\nx\nc\n"));
    assertEquals(Optional.empty(), UnifiedDiff.apply(diff, ""));
    assertEquals(Optional.empty(), UnifiedDiff.file("no diff"));
  }

  private static String name(int number) {
    return "file " + number + ".txt";
  }

  /** Shows ends of lines in the message of a failure. */
  private static String text(String text) {
    return text.replace("\r", "<CR>").replace("\n", "<LF>");
  }

  /** A diff does not delete or make a file without lines: a file that is not there is empty. */
  private static String textOf(Path file) throws IOException {
    return Files.exists(file) ? Files.readString(file) : "";
  }

  private static String apply(Path folder, Path diff) throws Exception {
    ProcessBuilder git =
        new ProcessBuilder("git", "apply", "--whitespace=nowarn", diff.toString())
            .directory(folder.toFile())
            .redirectErrorStream(true);
    git.environment().put("GIT_CEILING_DIRECTORIES", folder.getParent().toString());
    git.environment().put("GIT_CONFIG_GLOBAL", "/dev/null");
    git.environment().put("GIT_CONFIG_NOSYSTEM", "1");
    Process process = git.start();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    process.waitFor();
    return said;
  }

  private static void delete(Path folder) throws IOException {
    Files.walkFileTree(
        folder,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes)
              throws IOException {
            Files.delete(file);
            return FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult postVisitDirectory(Path each, IOException e) throws IOException {
            Files.delete(each);
            return FileVisitResult.CONTINUE;
          }
        });
  }

  @Provide
  Arbitrary<List<Change>> changes() {
    Arbitrary<Change> changed = Combinators.combine(texts().optional(0.9), texts()).as(Change::new);
    return changed.list().ofSize(50);
  }

  /** Texts of few different lines, so that two of them have lines in common. */
  private static Arbitrary<String> texts() {
    Arbitrary<String> line =
        Combinators.combine(
                Arbitraries.of("a", "b", "", "\\", "--- a", "+++ b", "@@ -1 +1 @@", "é"),
                Arbitraries.of("\n", "\r\n", "\n", "\r\n", "\r"))
            .as(String::concat);
    Arbitrary<String> last = Arbitraries.of("", "", "a", "last\r");
    return Combinators.combine(line.list().ofMaxSize(25), last)
        .as((lines, end) -> String.join("", lines) + end);
  }

  @Test
  void aTextThatStaysHasNoDiff() {
    assertEquals("", UnifiedDiff.of("x", Optional.of("a\nb"), "a\nb"));
    assertEquals("", UnifiedDiff.of("x", Optional.empty(), ""));
  }

  @Test
  void aNameWithSpacesEndsWithATab() {
    assertEquals(
        "--- a/x y\t\n+++ b/x y\t\n@@ -1,1 +1,1 @@\n-a\n+b\n",
        UnifiedDiff.of("x y", Optional.of("a\n"), "b\n"));
  }

  @Test
  void endsOfLinesStayAndAMissingOneIsMarked() {
    assertEquals(
        """
        --- a/x
        +++ b/x
        @@ -1,2 +1,2 @@
         a\r
        -b
        \\ No newline at end of file
        +b\r
        """,
        UnifiedDiff.of("x", Optional.of("a\r\nb"), "a\r\nb\r\n"));
    assertEquals(
        "--- /dev/null\n+++ b/x\n@@ -0,0 +1,1 @@\n+a\n",
        UnifiedDiff.of("x", Optional.empty(), "a\n"));
  }
}
