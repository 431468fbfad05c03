package dev.eventchain.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Set;
import java.util.TreeSet;
import java.util.jar.Manifest;
import org.junit.jupiter.api.Test;

/**
 * Tests that the Eclipse plug-ins import the packages of record 019 from our bundles. OSGi hides
 * everything that their manifests do not name.
 */
class PluginImportsTest {

  private static final Path PLUG_INS = Path.of("..", "..", "bundles", "front", "eclipse");
  private static final String OURS = "dev.eventchain.";

  private static Set<String> imports(String plugIn) throws IOException {
    Path file = PLUG_INS.resolve(plugIn).resolve("META-INF/MANIFEST.MF");
    Set<String> imports = new TreeSet<>();
    try (InputStream stream = Files.newInputStream(file)) {
      Manifest manifest = new Manifest(stream);
      for (String header : new String[] {"Require-Bundle", "Import-Package"}) {
        String value = String.valueOf(manifest.getMainAttributes().getValue(header));
        Arrays.stream(value.replaceAll("\"[^\"]*\"", "").split(","))
            .map(each -> each.replaceFirst(";.*", "").strip())
            .filter(each -> each.startsWith(OURS))
            .map(each -> each.substring(OURS.length()))
            .forEach(imports::add);
      }
    }
    return imports;
  }

  @Test
  void coreChecksWithoutStages() throws IOException {
    assertEquals(
        Set.of(
            "check",
            "constraints",
            "description",
            "diagnostics",
            "editing",
            "json-models",
            "m2t",
            "messages",
            "model",
            "project",
            "templates",
            "xmi"),
        imports("core"));
  }

  @Test
  void userInterfaceShowsWhatIsInModels() throws IOException {
    assertEquals(
        Set.of("diagnostics", "eclipse", "editing", "m2t", "messages", "model", "project", "xmi"),
        imports("ui"));
  }
}
