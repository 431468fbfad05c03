package dev.eventchain.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The numbers of refused system calls agree with the kernel's headers. */
class SystemCallNumbersTest {

  private static final String FOLDER = "src/main/resources/dev/eventchain/sandbox";
  private static final String PRINT =
      "import sys, json; sys.path.insert(0, sys.argv[1]); import kernel;"
          + "print(json.dumps(kernel.NUMBERS))";
  private static final Pattern DEFINITION =
      Pattern.compile("#define __NR(?:3264)?_(\\w+)\\s+(\\d+)\\s*");

  @ParameterizedTest
  @CsvSource({
    "0, /usr/include/x86_64-linux-gnu/asm/unistd_64.h, /usr/include/asm/unistd_64.h",
    "1, /usr/include/asm-generic/unistd.h, /usr/include/asm-generic/unistd.h"
  })
  void numberIsThatOfTheHeader(int column, Path debian, Path others) throws Exception {
    Path header = Files.exists(debian) ? debian : others;
    assumeTrue(Files.exists(header), "this machine has no kernel headers");
    Map<String, Integer> defined = definitions(header);
    JsonNode table = table();
    Map<String, String> expected = new TreeMap<>();
    Map<String, String> actual = new TreeMap<>();
    for (Map.Entry<String, JsonNode> entry : table.properties()) {
      JsonNode number = entry.getValue().get(column);
      String known = String.valueOf(defined.get(entry.getKey()));
      boolean youngerThanHeader = known.equals("null") && number.asInt() > 424;
      expected.put(entry.getKey(), youngerThanHeader ? number.asText() : known);
      actual.put(entry.getKey(), number.asText());
    }
    assertEquals(expected, actual);
  }

  private static Map<String, Integer> definitions(Path header) throws IOException {
    Map<String, Integer> numbers = new HashMap<>();
    for (String line : Files.readAllLines(header)) {
      Matcher definition = DEFINITION.matcher(line);
      if (definition.matches()) {
        numbers.putIfAbsent(definition.group(1), Integer.valueOf(definition.group(2)));
      }
    }
    return numbers;
  }

  private static JsonNode table() throws Exception {
    List<String> line =
        List.of(TestEnvironment.PYTHON.executable().toString(), "-B", "-c", PRINT, FOLDER);
    Process process = new ProcessBuilder(line).redirectErrorStream(true).start();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), output);
    return new ObjectMapper().readTree(output);
  }
}
