package dev.eventchain.m2t;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.m2t.generation.GenerationResult;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/**
 * Compares templates with recorded results of Acceleo. A case must differ if and only if it is
 * listed in {@code ACCELEO.md}.
 */
class RecordedCasesTest {
  private static final Path RECORDED = Path.of("src/test/resources/acceleo/recorded.json");
  private static final Pattern CASE = Pattern.compile("\\b[a-g]\\d\\d(-\\w+)*\\b");

  /** Result of a case; without files if it does not compile. */
  private record Outcome(Optional<SortedMap<String, String>> files, String findings) {}

  private final JsonNode recorded = read();
  private final String listed = list();

  @TestFactory
  Stream<DynamicTest> comesOutAsInAcceleoOrIsListed(@TempDir Path folder) throws IOException {
    for (Map.Entry<String, JsonNode> shared : recorded.get("shared").properties()) {
      String name = shared.getKey().equals("m.xmi") ? "model.xmi" : shared.getKey();
      Files.writeString(folder.resolve(name), shared.getValue().asText());
    }
    return recorded.get("cases").properties().stream()
        .map(
            each ->
                DynamicTest.dynamicTest(
                    each.getKey(), () -> check(each.getKey(), each.getValue(), folder)));
  }

  @Test
  void whatIsListedIsRecorded() {
    assertEquals(136, recorded.get("cases").size());
    Set<String> unknown = new TreeSet<>();
    Matcher names = CASE.matcher(listed);
    while (names.find()) {
      if (!recorded.get("cases").has(names.group())) {
        unknown.add(names.group());
      }
    }
    assertEquals(Set.of(), unknown);
  }

  private void check(String name, JsonNode each, Path folder) throws IOException {
    Outcome outcome = run(name, each, folder);
    SortedMap<String, String> expected = texts(each.get("files"));
    boolean same =
        each.get("compiles").asBoolean()
            ? outcome.files().equals(Optional.of(expected))
            : outcome.files().isEmpty();
    if (Pattern.compile("\\b" + name + "\\b").matcher(listed).find()) {
      assertTrue(!same, "comes out as in Acceleo: take it out of ACCELEO.md");
    } else if (!same) {
      assertEquals(expected, outcome.files().orElseGet(TreeMap::new), outcome.findings());
      fail("compiles in one of the two only\n" + outcome.findings());
    }
  }

  private static Outcome run(String name, JsonNode each, Path folder) throws IOException {
    Path own = Files.createDirectories(folder.resolve(name));
    for (Map.Entry<String, String> module : texts(each.get("modules")).entrySet()) {
      String file = module.getKey().equals("main.mtl") ? "template.mtl" : module.getKey();
      Files.createDirectories(own.resolve(file).getParent());
      Files.writeString(own.resolve(file), module.getValue());
    }
    try {
      TemplateCase.Prepared prepared = new TemplateCase(own).prepare();
      GenerationResult result = prepared.generate(UnaryOperator.identity());
      SortedMap<String, String> files = new TreeMap<>();
      result.files().forEach((file, bytes) -> files.put(file, new String(bytes, UTF_8)));
      return new Outcome(Optional.of(files), TemplateCase.text(result.diagnostics()));
    } catch (DiagnosticException e) {
      return new Outcome(Optional.empty(), TemplateCase.text(e.diagnostics()));
    }
  }

  private static SortedMap<String, String> texts(JsonNode node) {
    SortedMap<String, String> texts = new TreeMap<>();
    node.properties().forEach(each -> texts.put(each.getKey(), each.getValue().asText()));
    return texts;
  }

  private static JsonNode read() {
    try {
      return new ObjectMapper().readTree(RECORDED.toFile());
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  private static String list() {
    try {
      return Files.readString(Path.of("ACCELEO.md"));
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
