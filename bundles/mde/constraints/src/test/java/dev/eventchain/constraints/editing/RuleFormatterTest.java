package dev.eventchain.constraints.editing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.constraints.document.RuleDocument;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.ocl.dialect.Dialect;
import dev.eventchain.ocl.metamodel.PackageIndex;
import dev.eventchain.ocl.parse.OclAnalyzer;
import dev.eventchain.ocl.parse.OclEnvironment;
import dev.eventchain.ocl.parse.OclEnvironmentFactory;
import dev.eventchain.ocl.text.Symbol;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Formatted documents, and that they say what they said before. */
class RuleFormatterTest {

  private static final Path CASES = Path.of("src", "test", "resources", "formatting");
  private static final int RANDOM_TEXTS = 150;

  private static final OclEnvironment NAMES =
      new OclEnvironmentFactory(new PackageIndex(List.of()), Dialect.STANDARD).root();

  static List<Path> cases() throws IOException {
    return ExpectedFile.inputs(CASES, ".ocl");
  }

  @ParameterizedTest
  @MethodSource("cases")
  void everyCaseIsFormattedAsExpected(Path file) throws IOException {
    String text = Files.readString(file);
    String formatted = RuleFormatter.format(text, "  ").orElseThrow();
    ExpectedFile.check(ExpectedFile.beside(file), formatted);
    assertMeansTheSame(text, formatted);
  }

  @Test
  void lineBreaksStayAndTheLastLineGetsOne() {
    String text =
        "context Book inv A: self.pages > 0   and\n\tself.price>0 \r\n\tinv B: self.title   <> null\r"
            + "context Book::lend(to:people::Member):Boolean\r\n\r\nbody: to<>null\r\npre P:pages>0";
    String expected =
        "context Book inv A: self.pages > 0 and\n\tself.price > 0\r\n\tinv B: self.title <> null\r"
            + "context Book::lend(to : people::Member) : Boolean\r\n\r\n\tbody: to <> null\r\n"
            + "\tpre P: pages > 0\r\n";
    assertEquals(Optional.of(expected), RuleFormatter.format(text, "\t"));
    assertMeansTheSame(text, expected);
  }

  private static List<Path> documents() throws IOException {
    try (Stream<Path> files =
        Files.find(
            Repository.ROOT,
            30,
            (path, is) ->
                path.toString().endsWith(".ocl") && !path.toString().contains("target"))) {
      return files.sorted().toList();
    }
  }

  @Test
  void allDocumentsHereMeanTheSameAfterwards() throws IOException {
    int formatted = 0;
    for (Path file : documents()) {
      String text = Files.readString(file);
      Optional<String> found = RuleFormatter.format(text, "    ");
      found.ifPresent(each -> assertMeansTheSame(text, each));
      formatted += found.isPresent() ? 1 : 0;
    }
    assertTrue(formatted > 90, formatted + " documents");
  }

  /** Spaces are not what people meant by a text: it gets those of the formatter. */
  @Test
  void spacesAtRandomLeadToTheSameText() throws IOException {
    Random random = new Random(38);
    for (Path file : documents()) {
      String text = Files.readString(file);
      Optional<String> formatted = RuleFormatter.format(text, "  ");
      if (formatted.isPresent()) {
        assertEquals(
            formatted, RuleFormatter.format(withOtherSpaces(formatted.get(), random), "  "));
      }
    }
  }

  private static String withOtherSpaces(String text, Random random) {
    StringBuilder changed = new StringBuilder();
    for (Symbol each : Symbol.in(text)) {
      boolean aligned = each.kind() == Symbol.Kind.COMMENT || each.kind() == Symbol.Kind.END;
      String spaces = " \t  ".substring(0, 1 + random.nextInt(4));
      changed
          .append(aligned || each.gap().isEmpty() ? each.gap() : each.gap().replace(" ", spaces))
          .append(each.text());
    }
    return changed.toString();
  }

  @Test
  void expressionsAtRandomMeanTheSameAfterwards() {
    for (int seed = 0; seed < RANDOM_TEXTS; seed++) {
      RandomRules rules = new RandomRules(new Random(seed));
      String text = rules.document();
      Optional<String> formatted = RuleFormatter.format(text, "\t");
      assertTrue(formatted.isPresent(), text);
      assertMeansTheSame(text, formatted.get());
    }
  }

  /** A text that somebody is typing is never changed into another one. */
  @Test
  void halfOfATextIsLeftAloneOrMeansTheSame() throws IOException {
    String text = Files.readString(CASES.resolve("spaces.ocl"));
    int left = 0;
    for (int end = 0; end <= text.length(); end += 5) {
      String half = text.substring(0, end);
      Optional<String> formatted = RuleFormatter.format(half, "  ");
      formatted.ifPresent(each -> assertMeansTheSame(half, each));
      left += formatted.isEmpty() ? 1 : 0;
    }
    assertTrue(left > text.length() / 15, left + " of " + text.length() / 5);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "context Book inv A: (self.pages>0",
        "context Book inv A: self.pages == 0",
        "context Book inv A: if true then false",
        "context Book inv A: let a = 1 self.a",
        "context Book inv A: /* self.pages>0",
        "context Book inv : self.  ",
        "Books have pages."
      })
  void whatDoesNotParseIsLeftAlone(String text) {
    assertEquals(Optional.empty(), RuleFormatter.format(text, "  "));
  }

  private static void assertMeansTheSame(String text, String formatted) {
    assertEquals(trees(text), trees(formatted), text);
    assertEquals(comments(text), comments(formatted), text);
    assertEquals(
        text.stripTrailing().lines().map(String::isBlank).toList(),
        formatted.stripTrailing().lines().map(String::isBlank).toList());
    for (String step : List.of("  ", "\t")) {
      String again = RuleFormatter.format(formatted, step).orElseThrow();
      assertEquals(Optional.of(again), RuleFormatter.format(again, step));
    }
    assertTrue(formatted.isEmpty() || "\r\n".contains(formatted.substring(formatted.length() - 1)));
  }

  private static List<String> comments(String text) {
    return Symbol.in(text).stream()
        .filter(each -> each.kind() == Symbol.Kind.COMMENT)
        .map(Symbol::text)
        .toList();
  }

  /** Returns the clauses of a document with the parser's trees of their expressions. */
  private static List<String> trees(String text) {
    List<String> trees = new ArrayList<>();
    RuleDocument document = RuleDocument.read(SourceText.of("rules", text), new ArrayList<>());
    for (RuleDocument.Clause each : document.clauses()) {
      String message = each.message() == null ? "" : tree("inv:\n" + each.message().text());
      String prefix = each.definition() ? "" : "inv:\n";
      trees.add(
          String.join(
              " ",
              String.valueOf(each.packagePath()),
              each.context().toString(),
              each.alias(),
              each.name(),
              message,
              tree(prefix + each.text().text())));
    }
    document
        .members()
        .forEach(each -> trees.add(each.name() + tree("inv:\n" + each.text().text())));
    document.imports().forEach(each -> trees.add(each.target()));
    return trees;
  }

  private static String tree(String text) {
    return describe(new OclAnalyzer(NAMES, text.replace('\r', '\n')).parseConcreteSyntax());
  }

  /** Returns a tree without the places of its nodes. */
  private static String describe(EObject node) {
    StringBuilder text = new StringBuilder(node.eClass().getName());
    for (EAttribute each : node.eClass().getEAllAttributes()) {
      boolean isPlace = each.getName().contains("Offset") || each.getName().contains("Token");
      text.append(isPlace || !node.eIsSet(each) ? "" : " " + node.eGet(each));
    }
    for (EReference each : node.eClass().getEAllReferences()) {
      boolean isPart = each.isContainment() && node.eIsSet(each);
      text.append(isPart ? " " + each.getName() + describeAll(node.eGet(each)) : "");
    }
    return text.toString();
  }

  private static String describeAll(Object value) {
    return value instanceof List<?> all
        ? all.stream()
            .map(each -> describe((EObject) each))
            .collect(Collectors.joining(", ", "[", "]"))
        : "(" + describe((EObject) value) + ")";
  }
}
