package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests the language server with the client of an editor that others wrote; skipped where there is
 * no Neovim.
 */
class NeovimTest {

  private static final Path SESSION =
      Program.ROOT.resolve("tests/end-to-end/src/test/resources/neovim/session.lua");

  /** The cursor's place in line 4 is that of a definition, which line 6 uses. */
  private static final String RULES =
      """
      -- Rules of a library, with a letter of two bytes: é.
      import 'library.ecore'
      context Book
        def: isLong : Boolean = self.pages > 1000
        inv HasTitle: /* 😀 */ self.titel <> null
        inv IsShort: not self.isLong
      """;

  private static final String METAMODEL =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <ecore:EPackage xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI"
          xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
          xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore" name="library"
          nsURI="http://example.org/library" nsPrefix="library">
        <eClassifiers xsi:type="ecore:EClass" name="Book">
          <eStructuralFeatures xsi:type="ecore:EAttribute" name="title" lowerBound="1"
              eType="ecore:EDataType http://www.eclipse.org/emf/2002/Ecore#//EString"/>
          <eStructuralFeatures xsi:type="ecore:EAttribute" name="pages"
              eType="ecore:EDataType http://www.eclipse.org/emf/2002/Ecore#//EInt"/>
        </eClassifiers>
      </ecore:EPackage>
      """;

  @TempDir Path folder;

  @Test
  void peopleFixAndRenameWhatTheServerFinds() throws Exception {
    boolean isThere =
        Stream.of(System.getenv("PATH").split(":", -1))
            .anyMatch(path -> Files.isExecutable(Path.of(path, "nvim")));
    assumeTrue(isThere, "there is no Neovim");
    Files.writeString(folder.resolve("library.ecore"), METAMODEL);
    Map<String, String> said = session(Files.writeString(folder.resolve("rules.ocl"), RULES));
    // Columns of Neovim are bytes: the emoji before it has four.
    assertEquals("5:33 Book has no feature 'titel'.", said.get("findings"), said::toString);
    assertTrue(said.get("hover").contains("Boolean"), said::toString);
    assertEquals("true true", said.get("completion"), said::toString);
    assertEquals("isLong", said.get("definition"), said::toString);
    assertEquals("def: isHuge : Boolean = self.pages > 1000", said.get("renamed"), said::toString);
    assertTrue(said.containsKey("no findings") && said.containsKey("all is well"), said::toString);
  }

  /** Returns what the session says, by the word before each colon. */
  private Map<String, String> session(Path file) throws IOException, InterruptedException {
    Path script = Files.writeString(folder.resolve("eventchain"), new Program().script());
    assertTrue(script.toFile().setExecutable(true));
    Path printed = folder.resolve("printed");
    ProcessBuilder builder =
        new ProcessBuilder(
            "nvim", "--headless", "-u", "NONE", "-i", "NONE", "-n", "-S", SESSION.toString());
    builder
        .environment()
        .putAll(Map.of("EVENTCHAIN_SCRIPT", script.toString(), "EVENTCHAIN_FILE", file.toString()));
    Process process = builder.redirectErrorStream(true).redirectOutput(printed.toFile()).start();
    try {
      assertTrue(process.waitFor(5, TimeUnit.MINUTES), () -> text(printed));
      assertEquals(0, process.exitValue(), () -> text(printed));
    } finally {
      process.destroyForcibly();
    }
    Map<String, String> said = new TreeMap<>();
    for (String line : text(printed).lines().toList()) {
      List<String> parts = List.of(line.strip().split(": ", 2));
      said.put(parts.get(0), parts.size() > 1 ? parts.get(1) : "");
    }
    return said;
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
