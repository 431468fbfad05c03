package dev.eventchain.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import dev.eventchain.messages.MemberNames;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PythonNamesTest {

  private static final Path ROOT = Path.of("../../..").toAbsolutePath().normalize();
  private static final String TEMPLATE = "templates/python/reserved.mtl";

  @ParameterizedTest
  @CsvSource({
    "TTC_Calculation, true",
    "_x2, true",
    "Nonlocal, true",
    "match, true",
    "mainly, true",
    "nonlocal, false",
    "None, false",
    "self, false",
    "main, false",
    "rclpy, false",
    "__init__, false",
    "__x, false",
    "2x, false",
    "a b, false",
    "Größe, false",
    "'', false"
  })
  void namesAreFreeOrNot(String name, boolean free) {
    assertEquals(free, PythonNames.isFreeIdentifier(name));
  }

  @Test
  void theKeywordsAreThoseOfPython() throws Exception {
    Process python =
        new ProcessBuilder("python3", "-c", "import keyword; print('\\n'.join(keyword.kwlist))")
            .redirectErrorStream(true)
            .start();
    String output = new String(python.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, python.waitFor(), output);
    assertEquals(output.lines().toList(), PythonNames.keywords());
  }

  /** Templates cannot call Java; this test compares their copy of the list with the original. */
  @Test
  void theTemplatesHaveTheSameNames() throws IOException {
    Path file = ROOT.resolve(TEMPLATE);
    if (Files.notExists(file)) {
      Files.writeString(file, template());
      fail(file + " was not there; it is now");
    }
    assertEquals(template(), Files.readString(file), "delete it and test again: it is written");
  }

  private static String template() {
    List<String> lines = new ArrayList<>();
    StringBuilder line = new StringBuilder(" ");
    for (String name : PythonNames.reserved()) {
      String next = " '" + name + "',";
      if (line.length() + next.length() > 120) {
        lines.add(line.toString());
        line = new StringBuilder(" ");
      }
      line.append(next);
    }
    lines.add(line.substring(0, line.length() - 1));
    return """
    [comment encoding = UTF-8 /]
    [**
     * The names that no name of a model can have in Python. Written from metamodel/eventchain.ocl: change them there.
     */]
    [module reserved('http://eventchain.dev/eventchain/1.0')]

    [** Words that cannot be names in Python, and names that the generated modules use themselves. */]
    [query public reservedNames() : Set(String) = Set{
    %s
    } /]
    """
        .formatted(String.join("\n", lines));
  }

  @Test
  void thereIsNoOtherList() throws IOException {
    List<String> found = new ArrayList<>();
    for (String folder : List.of("bundles", "templates", "metamodel", "examples")) {
      try (Stream<Path> all = Files.walk(ROOT.resolve(folder))) {
        for (Path file : all.filter(PythonNamesTest::isSource).sorted().toList()) {
          if (Files.readString(file).contains("nonlocal")) {
            found.add(ROOT.relativize(file).toString());
          }
        }
      }
    }
    assertEquals(
        List.of(
            "bundles/robot/messages/src/main/java/dev/eventchain/messages/MemberNames.java",
            "templates/python/reserved.mtl",
            "metamodel/eventchain.ocl"),
        found);
  }

  /** Message definitions do not know event chains, so their list cannot be read from there. */
  @Test
  void messagesRefuseTheSameKeywords() {
    assertEquals(new TreeSet<>(PythonNames.keywords()), new TreeSet<>(MemberNames.keywords()));
  }

  private static boolean isSource(Path file) {
    String name = file.toString();
    return name.matches(".*\\.(java|mtl|ocl|ecore)")
        && !name.contains("/src/test/")
        && !name.contains("/target/")
        && !name.contains("/out/");
  }

  @Test
  void everyListedNameIsRefused() {
    assertTrue(PythonNames.reserved().size() > 35);
    assertTrue(PythonNames.reserved().stream().noneMatch(PythonNames::isFreeIdentifier));
  }
}
