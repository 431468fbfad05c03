package dev.eventchain.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Each file {@code components/RULE/NAME.py} is checked against {@code NAME.expected} beside it;
 * without one, {@code good} files must have no findings, and for others it is written. The {@code
 * signature.json} of the folder describes the required component.
 */
class ComponentProbeTest {

  private static final Path FIXTURES = Path.of("src/test/resources/components");
  private static final ObjectMapper JSON = new ObjectMapper();

  static Stream<Arguments> components() throws IOException {
    try (Stream<Path> files = Files.walk(FIXTURES)) {
      List<Path> components =
          files.filter(file -> file.toString().endsWith(".py")).sorted().toList();
      return IntStream.range(0, components.size())
          .boxed()
          .flatMap(
              index ->
                  confinements(index).stream()
                      .map(confinement -> Arguments.of(components.get(index), confinement)));
    }
  }

  /** All in the profile {@code thorough}, else another one each day. */
  private static List<Confinement> confinements(int component) {
    List<Confinement> all = TestEnvironment.confinements();
    return Thorough.IS_ON
        ? all
        : List.of(all.get(Math.floorMod(Thorough.turn() + component, all.size())));
  }

  @ParameterizedTest
  @MethodSource("components")
  void findingsAreAsExpected(Path component, Confinement confinement) throws IOException {
    String actual = DiagnosticFormat.TEXT.render(check(component, confinement));
    if (component.getFileName().toString().startsWith("good")) {
      assertEquals("", actual);
    } else {
      ExpectedFile.check(ExpectedFile.beside(component), actual);
    }
  }

  private static List<Diagnostic> check(Path component, Confinement confinement)
      throws IOException {
    Path description = component.resolveSibling("signature.json");
    JsonNode settings =
        JSON.readTree(
            Files.exists(description)
                ? description.toFile()
                : FIXTURES.resolve("signature.json").toFile());
    ComponentSignature signature =
        new ComponentSignature(
            settings.get("class").asText(),
            strings(settings.get("inputs")),
            strings(settings.get("outputs")));
    List<ComponentCall> calls = new ArrayList<>();
    for (JsonNode call : settings.get("calls")) {
      calls.add(new ComponentCall(call.get("name").asText(), arguments(call.get("arguments"))));
    }
    Duration timeLimit = Duration.ofMillis(800);
    return new ComponentProbe(TestEnvironment.PYTHON, timeLimit, Duration.ofMinutes(5), confinement)
        .check(component, signature, calls);
  }

  private static List<String> strings(JsonNode array) {
    List<String> strings = new ArrayList<>();
    array.forEach(entry -> strings.add(entry.asText()));
    return strings;
  }

  private static Map<String, Object> arguments(JsonNode object) {
    Map<String, Object> arguments = new LinkedHashMap<>();
    for (var entry : object.properties()) {
      arguments.put(entry.getKey(), JSON.convertValue(entry.getValue(), Object.class));
    }
    return arguments;
  }
}
