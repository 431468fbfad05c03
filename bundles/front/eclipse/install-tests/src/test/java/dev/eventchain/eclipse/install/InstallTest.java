package dev.eventchain.eclipse.install;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;

/** Tests the installation of the update site into an Eclipse without our bundles. */
class InstallTest {

  private static final long LARGEST_SITE_BYTES = 15_000_000;

  @TempDir Path scratch;

  @InTurn
  @Test
  void theSiteInstallsIntoAnEclipseWithoutUs() throws Exception {
    Installation eclipse = Installation.copy(scratch);
    eclipse.direct("-uninstallIU", Built.FEATURE);
    Set<String> before = eclipse.bundles().keySet();
    for (String name : all()) {
      assertFalse(before.contains(name), name);
    }

    eclipse.direct("-repository", Built.SITE.toUri().toString(), "-installIU", Built.FEATURE);
    SortedMap<String, Path> after = eclipse.bundles();
    SortedSet<String> added = new TreeSet<>(after.keySet());
    added.removeAll(before);
    assertEquals(all(), added);
    assertEquals(new TreeMap<>(), unusable(after));
  }

  /** An Eclipse may lack all bundles that are not its own. */
  @Test
  void theSiteBringsWhatOurBundlesNeedAndIsNotOfEclipse() throws Exception {
    Installation workbench = new Installation(Built.WORKBENCH, scratch);
    SortedSet<String> missing = new TreeSet<>();
    try (Wiring wiring = new Wiring(workbench.bundles(), scratch.resolve("framework"))) {
      for (String name : Built.ours()) {
        assertEquals("", wiring.unresolved(name), name);
        missing.addAll(wiring.providers(name));
      }
    }
    assertTrue(missing.removeAll(Built.theirs()), "nothing of others is wired");
    missing.removeAll(Built.ours());
    missing.removeIf(name -> name.startsWith("org.eclipse."));
    assertEquals(Set.of(), missing);
  }

  @Test
  void theSiteIsSmall() throws IOException {
    try (Stream<Path> files = Files.walk(Built.SITE)) {
      long bytes =
          files.mapToLong(file -> file.toFile().isFile() ? file.toFile().length() : 0).sum();
      assertTrue(bytes < LARGEST_SITE_BYTES, () -> bytes + " bytes");
    }
  }

  @Test
  void theFeatureShowsTheProjectsLicense() throws Exception {
    Document feature =
        DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(Built.FEATURE_XML.toFile());
    String shown = feature.getElementsByTagName("license").item(0).getTextContent();
    assertEquals(Files.readString(Built.LICENSE).strip(), shown.strip());
  }

  /** Returns the problems of our installed bundles, by bundle or class. */
  private SortedMap<String, String> unusable(SortedMap<String, Path> installed) throws Exception {
    SortedMap<String, String> unusable = new TreeMap<>();
    int classes = 0;
    try (Wiring wiring = new Wiring(installed, scratch.resolve("framework"))) {
      for (String name : Built.ours()) {
        String why = wiring.unresolved(name);
        if (!why.isEmpty()) {
          unusable.put(name, why);
          continue;
        }
        for (String className : wiring.named(name)) {
          classes++;
          try {
            wiring.load(name, className);
          } catch (ClassNotFoundException | LinkageError e) {
            unusable.put(className, e.toString());
          }
        }
      }
    }
    assertTrue(classes > 0, "no extension names a class");
    return unusable;
  }

  private static SortedSet<String> all() throws IOException {
    SortedSet<String> all = Built.ours();
    all.addAll(Built.theirs());
    return all;
  }
}
