package dev.eventchain.m2t;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import dev.eventchain.m2t.library.OperationTable;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/**
 * One test for each folder with a {@link TemplateCase}. Next to the template are the expected files
 * ({@code expected/}) and the expected findings ({@code findings.txt}, absent if there are none).
 * For a case without expectations, the actual results are written, and the test fails once.
 */
class TemplateCasesTest {
  private static final Path CASES = Path.of("src/test/resources/cases");

  @TestFactory
  Stream<DynamicTest> cases() throws IOException {
    List<Path> folders;
    try (Stream<Path> all = Files.walk(CASES)) {
      folders = all.filter(TemplateCase::isCase).sorted().toList();
    }
    return folders.stream()
        .map(f -> DynamicTest.dynamicTest(CASES.relativize(f).toString(), () -> check(f)));
  }

  @Test
  void whiteSpaceHasSixtyCasesOfItsOwnAndTheLanguageTwoHundred() throws IOException {
    assertTrue(templates("").size() >= 200, "cases");
    assertTrue(templates("whitespace").size() >= 60, "cases of white space");
  }

  @Test
  void everyOperationOccursInACase() throws IOException {
    String all = String.join("\n", templates(""));
    Set<String> missing = new TreeSet<>();
    Matcher operation =
        Pattern.compile("`(\\w+)\\(").matcher(Files.readString(Path.of("OPERATIONS.md")));
    while (operation.find()) {
      if (!Pattern.compile("\\b" + operation.group(1) + "\\(").matcher(all).find()) {
        missing.add(operation.group(1));
      }
    }
    assertEquals(Set.of(), missing);
  }

  @Test
  void everyOperationIsListed() throws IOException {
    String listed = Files.readString(Path.of("OPERATIONS.md"));
    assertEquals(
        List.of(),
        new OperationTable()
            .names().stream().filter(name -> !listed.contains("`" + name + "(")).toList());
  }

  @Test
  void everyKeywordOccursInACase() throws IOException {
    String all = String.join("\n", templates(""));
    List<String> keywords =
        List.of(
            "[module ",
            " extends ",
            "[import ",
            "[template ",
            "[/template]",
            "public ",
            "private ",
            "protected ",
            " overrides ",
            " ? (",
            " post (",
            "[query ",
            "[for (",
            "[/for]",
            "before(",
            "separator(",
            "after(",
            "[if (",
            "[elseif (",
            "[else]",
            "[/if]",
            "[let ",
            "[elselet ",
            "[/let]",
            "[file (",
            "[/file]",
            "[protected (",
            "startTagPrefix(",
            "endTagPrefix(",
            "[/protected]",
            "[super/]",
            "[trace ",
            "[macro ",
            "[comment]",
            "[comment ",
            "@main",
            "[--",
            "[**",
            "invoke(");
    assertEquals(List.of(), keywords.stream().filter(each -> !all.contains(each)).toList());
  }

  /** Returns the texts of the templates of all cases in a folder. */
  private static List<String> templates(String folder) throws IOException {
    List<String> texts = new ArrayList<>();
    try (Stream<Path> all = Files.walk(CASES.resolve(folder))) {
      for (Path file : all.filter(f -> f.endsWith("template.mtl")).sorted().toList()) {
        texts.add(Files.readString(file));
      }
    }
    return texts;
  }

  private void check(Path folder) throws IOException {
    TemplateCase.Outcome outcome = new TemplateCase(folder).run();
    Path expected = folder.resolve("expected");
    Path findings = folder.resolve("findings.txt");
    if (!Files.exists(expected) && !Files.exists(findings)) {
      writeActual(expected, findings, outcome);
      fail("there was no expectation; look at what was written into " + folder);
    }
    String expectedFindings = Files.exists(findings) ? Files.readString(findings) : "";
    assertEquals(expectedFindings, outcome.findings());
    SortedMap<String, String> expectedFiles = filesIn(expected);
    assertEquals(expectedFiles.keySet(), outcome.files().keySet());
    outcome
        .files()
        .forEach((name, bytes) -> assertEquals(expectedFiles.get(name), text(bytes), name));
  }

  private static void writeActual(Path expected, Path findings, TemplateCase.Outcome outcome)
      throws IOException {
    if (!outcome.findings().isEmpty()) {
      Files.writeString(findings, outcome.findings());
    }
    for (var file : outcome.files().entrySet()) {
      Path path = expected.resolve(file.getKey());
      Files.createDirectories(path.getParent());
      Files.write(path, file.getValue());
    }
  }

  private static SortedMap<String, String> filesIn(Path folder) throws IOException {
    SortedMap<String, String> files = new TreeMap<>();
    if (!Files.exists(folder)) {
      return files;
    }
    try (Stream<Path> all = Files.walk(folder)) {
      for (Path file : all.filter(Files::isRegularFile).toList()) {
        String name = folder.relativize(file).toString().replace('\\', '/');
        files.put(name, text(Files.readAllBytes(file)));
      }
    }
    return files;
  }

  /** Returns bytes as a text that shows every difference in any encoding. */
  private static String text(byte[] bytes) {
    String decoded = new String(bytes, UTF_8);
    return java.util.Arrays.equals(decoded.getBytes(UTF_8), bytes)
        ? decoded
        : new String(bytes, java.nio.charset.StandardCharsets.ISO_8859_1);
  }
}
