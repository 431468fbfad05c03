package dev.eventchain.pipeline.evidence.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.pipeline.evidence.Evidence;
import dev.eventchain.pipeline.evidence.Evidence.Requirement;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ReqifVerdictsTest {

  private static final Path FILES =
      Path.of("src/test/resources/dev/eventchain/pipeline/evidence/format/reqif");

  @TempDir private Path folder;

  /** Returns evidence for some of the requirements, as if they came from a document. */
  private static Evidence from(Path document, String... ids) {
    Evidence full = Evidences.full();
    return new Evidence(
        full.name(),
        full.title(),
        full.summary(),
        full.requirements().stream()
            .filter(each -> List.of(ids).contains(each.id()))
            .map(
                each ->
                    new Requirement(
                        each.id(),
                        each.text(),
                        SourceLocation.of(document),
                        each.verdict(),
                        each.reason(),
                        each.strength()))
            .toList(),
        full.components(),
        full.tests());
  }

  private static byte[] reqif(Evidence evidence) throws IOException {
    return EvidenceFormat.REQIF.render(evidence, Path.of("x.reqif")).get("");
  }

  @Test
  void requirementsOfOtherFilesGetADocumentOfTheirOwn() throws IOException {
    String document = new String(reqif(Evidences.full()), StandardCharsets.UTF_8);
    ExpectedFile.check(FILES.resolve("new.reqif"), document);
  }

  @Test
  void aDocumentGetsVerdictsAndKeepsEverythingElse() throws IOException {
    Path source = FILES.resolve("source.reqif");
    Evidence evidence = from(source, "BRK-1", "BRK-3", "BRK-4");
    String copy = new String(reqif(evidence), StandardCharsets.UTF_8);
    ExpectedFile.check(FILES.resolve("copy.reqif"), copy);
    Path second = Files.writeString(folder.resolve("second.reqif"), copy);
    Evidence again = from(second, "BRK-1", "BRK-3", "BRK-4");
    assertEquals(copy, new String(reqif(again), StandardCharsets.UTF_8), "replaces its own");
  }

  @ParameterizedTest
  @ValueSource(strings = {"UTF-8", "UTF-16LE", "UTF-16BE", "ISO-8859-1"})
  void encodingAndLineEndsAreKept(String name) throws IOException {
    Charset charset = Charset.forName(name);
    String mark = name.startsWith("UTF") ? "\uFEFF" : "";
    String declared = name.startsWith("UTF-16") ? "UTF-16" : name;
    String text =
        mark
            + Files.readString(FILES.resolve("source.reqif"))
                .replace("encoding=\"UTF-8\"", "encoding=\"" + declared + "\"")
                .replace("It <xhtml:b>", "Ü: it <xhtml:b>")
                .replace("\n", "\r\n");
    Path file = Files.write(folder.resolve("other.reqif"), text.getBytes(charset));
    String copy = new String(reqif(from(file, "BRK-1")), charset);
    assertTrue(copy.contains("Ü: it "), copy);
    assertEquals(copy.lines().count(), copy.split("\r\n", -1).length - 1, "no other line ends");
    List<String> kept = copy.lines().toList();
    int next = 0;
    for (String line : text.lines().toList()) {
      while (next < kept.size() && !kept.get(next).equals(line)) {
        next++;
      }
      assertTrue(next++ < kept.size(), line);
    }
    assertArrayEquals(copy.getBytes(charset), reqif(from(file, "BRK-1")));
  }

  @Test
  void aDocumentThatCannotBeUsedSaysWhy() throws IOException {
    Path source = FILES.resolve("source.reqif");
    assertSays("has no object for BRK-2", from(source, "BRK-1", "BRK-2"));
    Path broken = Files.writeString(folder.resolve("broken.reqif"), "<REQ-IF>");
    assertSays("is no ReqIF document", from(broken, "BRK-1"));
    Path other = Files.writeString(folder.resolve("other.reqif"), "<a/>");
    assertSays("has no object for BRK-1", from(other, "BRK-1"));
    Path dtd = Files.writeString(folder.resolve("dtd.reqif"), "<!DOCTYPE a []><a/>");
    assertSays("is no ReqIF document", from(dtd, "BRK-1"));
    Path unknown =
        Files.writeString(
            folder.resolve("unknown.reqif"), "<?xml version='1.0' encoding='x-y'?><a/>");
    assertThrows(IOException.class, () -> reqif(from(unknown, "BRK-1")));
    assertThrows(IOException.class, () -> reqif(from(folder.resolve("no.reqif"), "BRK-1")));
  }

  private static void assertSays(String part, Evidence evidence) {
    IOException refused = assertThrows(IOException.class, () -> reqif(evidence));
    assertTrue(refused.getMessage().contains(part), refused.getMessage());
  }
}
