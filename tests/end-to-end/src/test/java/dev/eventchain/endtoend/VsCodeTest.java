package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.Thorough;
import dev.eventchain.m2t.TemplateParts;
import dev.eventchain.ocl.text.Keywords;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests the extension for VS Code as far as no VS Code is needed; what runs its code is skipped
 * where there is no Node, and what needs its packages where the build could not get them.
 */
class VsCodeTest {

  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final Path EXTENSION = Program.ROOT.resolve("bundles/front/vscode");
  private static final Path PACKAGES = EXTENSION.resolve("target/npm/node_modules");
  private static final String CLIENT = "test/client.test.js";
  private static final Pattern ALTERNATIVES = Pattern.compile("\\\\b\\(\\?:([A-Za-z|]+)\\)\\\\b");
  private static final Pattern BLOCKS =
      Pattern.compile("\\(([a-z|]+)\\)\\(\\?=\\[\\\\s\\(\\\\]\\]\\)");

  /** Templates whose tags do not end: a grammar goes on to the next tag, a lexer gives up. */
  private static final List<String> BROKEN = List.of("/cases/errors/", "/front/eclipse/tests/");

  @TempDir Path folder;

  @Test
  void everythingThatTheExtensionNamesIsInTheArchive() throws IOException {
    try (ZipFile archive = archive()) {
      JsonNode extension = MAPPER.readTree(read(archive, "extension/package.json"));
      List<String> named = new ArrayList<>(extension.findValuesAsText("path"));
      named.addAll(extension.at("/contributes/languages").findValuesAsText("configuration"));
      named.add(extension.path("main").asText());
      named.addAll(List.of("README.md", "LICENSE.txt", "program/bin/eventchain"));
      for (String name : named) {
        String entry = Path.of("extension", name).normalize().toString();
        assertTrue(archive.getEntry(entry) != null, entry);
      }
      assertTrue(named.size() > 8, named::toString);
      String manifest = read(archive, "extension.vsixmanifest");
      String version = extension.path("version").asText();
      assertTrue(manifest.contains("Id=\"eventchain\" Version=\"" + version + "\""), manifest);
      assertTrue(read(archive, "[Content_Types].xml").contains("Extension=\".jar\""));
    }
  }

  @Test
  void packagesAreThoseOfTheLockFileWithTheirLicences() throws IOException {
    JsonNode lock = MAPPER.readTree(EXTENSION.resolve("package-lock.json").toFile());
    Set<String> locked = new TreeSet<>();
    lock.path("packages").fieldNames().forEachRemaining(locked::add);
    assertTrue(locked.remove(""), "the extension itself");
    Set<String> packed = new TreeSet<>();
    Set<String> licensed = new TreeSet<>();
    try (ZipFile archive = archive()) {
      Pattern part = Pattern.compile("extension/(node_modules/[^/@]+)/([^/]+)");
      for (ZipEntry entry : Collections.list(archive.entries())) {
        Matcher name = part.matcher(entry.getName());
        if (name.matches()) {
          packed.add(name.group(1));
          if (name.group(2).matches("(?i)licen[sc]e.*")) {
            licensed.add(name.group(1));
          }
        }
      }
    }
    assertEquals(locked, packed);
    assertEquals(locked, licensed);
  }

  @Test
  void theLockFilePinsAndNamesNoRegistry() throws IOException {
    JsonNode lock = MAPPER.readTree(EXTENSION.resolve("package-lock.json").toFile());
    JsonNode extension = MAPPER.readTree(EXTENSION.resolve("package.json").toFile());
    assertEquals(extension.path("version"), lock.path("version"));
    assertEquals(
        extension.path("dependencies"), lock.path("packages").path("").path("dependencies"));
    for (JsonNode version : extension.path("dependencies")) {
      assertTrue(version.asText().matches("\\d+\\.\\d+\\.\\d+"), version::asText);
    }
    assertEquals(List.of(), lock.findValues("resolved"));
    int packages = lock.path("packages").size() - 1;
    assertTrue(packages > 0);
    assertEquals(packages, lock.findValues("integrity").size());
  }

  @Test
  void withoutNpmThereIsNoArchiveButTheReason() throws Exception {
    String said = packed("/nowhere", "anywhere");
    assertEquals("The extension for VS Code is not made: there is no npm here.\n", said);
    assertEquals("there is no npm here\n", Files.readString(folder.resolve("a/a.missing")));
    assertFalse(Files.exists(folder.resolve("a/a.vsix")));
  }

  @Test
  void whereTheRegistryCannotBeReachedThereIsNoArchiveButTheReason() throws Exception {
    assumeTrue(isThere("npm"), "there is no npm");
    String said = packed(System.getenv("PATH"), "http://127.0.0.1:9/");
    String reason = "The extension for VS Code is not made: npm could not get its packages: ";
    assertTrue(said.startsWith(reason) && said.contains("ECONNREFUSED"), said);
    assertEquals(1, said.lines().count(), said);
    assertFalse(Files.exists(folder.resolve("a/a.vsix")));
  }

  /** Packs into an empty folder, where there was an older archive, and returns what is said. */
  private String packed(String path, String registry) throws IOException, InterruptedException {
    Files.createDirectories(folder.resolve("a"));
    Path archive = Files.createFile(folder.resolve("a/a.vsix"));
    String itself = "import sys; print(sys.executable)"; // what is on the path may be a script
    String python = run(List.of("python3", "-c", itself), Map.of()).strip();
    List<String> command = List.of(python, "build/pack-vsix", "none.zip", "0", archive.toString());
    Map<String, String> environment =
        Map.of(
            "PATH",
            path,
            "npm_config_registry",
            registry,
            "npm_config_cache",
            folder.resolve("cache").toString());
    return run(command, environment);
  }

  @Test
  void everyCommandIsRegistered() throws IOException {
    JsonNode extension = MAPPER.readTree(EXTENSION.resolve("package.json").toFile());
    String source = Files.readString(EXTENSION.resolve("source/extension.js"));
    String all = Files.readString(EXTENSION.resolve("source/tasks.js"));
    Matcher commands = Pattern.compile("COMMANDS = (\\[.*])").matcher(all);
    assertTrue(commands.find());
    Set<String> registered = new TreeSet<>();
    MAPPER
        .readTree(commands.group(1))
        .forEach(name -> registered.add("eventchain." + name.asText()));
    Pattern.compile("command\\(\"(\\w+)\"")
        .matcher(source)
        .results()
        .forEach(found -> registered.add("eventchain." + found.group(1)));
    Set<String> declared =
        new TreeSet<>(extension.at("/contributes/commands").findValuesAsText("command"));
    assertEquals(declared, registered);
    Set<String> inMenus =
        new TreeSet<>(extension.at("/contributes/menus").findValuesAsText("command"));
    assertTrue(inMenus.size() > 3 && declared.containsAll(inMenus), inMenus::toString);
  }

  @Test
  void grammarsHaveTheWordsOfTheEngine() throws IOException {
    Set<String> ocl = words(ALTERNATIVES, "ocl");
    ocl.add("self");
    assertEquals(union(Keywords.ALL, Keywords.TYPES), ocl);
    assertEquals(new TreeSet<>(TemplateParts.MODIFIERS), words(ALTERNATIVES, "mtl"));
    Set<String> blocks = words(BLOCKS, "mtl");
    blocks.add("comment");
    assertEquals(new TreeSet<>(TemplateParts.KEYWORDS), blocks);
  }

  /** Returns the alternatives of all patterns of a grammar. */
  private static Set<String> words(Pattern pattern, String language) throws IOException {
    Path file = EXTENSION.resolve("syntaxes/" + language + ".tmLanguage.json");
    Set<String> words = new TreeSet<>();
    for (String key : List.of("match", "begin")) {
      for (String expression : MAPPER.readTree(file.toFile()).findValuesAsText(key)) {
        pattern
            .matcher(expression)
            .results()
            .forEach(found -> words.addAll(List.of(found.group(1).split("\\|", -1))));
      }
    }
    return words;
  }

  private static Set<String> union(Collection<String> first, Collection<String> second) {
    return Stream.of(first, second)
        .flatMap(Collection::stream)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  @Test
  void commentsAndTagsOfTemplatesAreWhereTheEngineSeesThem() throws Exception {
    List<String> files = templates();
    assertTrue(files.size() > 500, files.size() + " templates");
    JsonNode seen =
        MAPPER.readTree(node(Stream.concat(Stream.of("test/kinds.js"), files.stream())));
    List<String> different = new ArrayList<>();
    for (String file : files) {
      List<String> expected =
          TemplateParts.of(Files.readString(Path.of(file))).stream()
              .map(part -> part.start() + " " + part.end() + " " + part.kind())
              .toList();
      List<String> actual = new ArrayList<>();
      seen.path(file)
          .forEach(
              part -> actual.add(part.get(0) + " " + part.get(1) + " " + part.get(2).asText()));
      if (!merged(expected).equals(merged(actual))) {
        different.add(file);
      }
    }
    assertEquals(List.of(), different);
  }

  private static List<String> templates() throws IOException {
    try (Stream<Path> all = Files.walk(Program.ROOT)) {
      return all.map(Path::toString)
          .filter(name -> name.endsWith(".mtl") && !name.contains("/target/"))
          .filter(name -> BROKEN.stream().noneMatch(name::contains))
          .sorted()
          .toList();
    }
  }

  /** Returns parts with those together that touch and are of one kind. */
  private static List<String> merged(List<String> parts) {
    List<String> merged = new ArrayList<>();
    for (String part : parts) {
      String[] words = part.split(" ", -1);
      int last = merged.size() - 1;
      String[] before = last < 0 ? new String[] {"", "", ""} : merged.get(last).split(" ", -1);
      if (before[2].equals(words[2])) {
        merged.set(last, before[0] + " " + words[1] + " " + words[2]);
      } else {
        merged.add(part);
      }
    }
    return merged;
  }

  @Test
  void codeOfTheExtension() throws Exception {
    List<String> tests;
    try (Stream<Path> files = Files.list(EXTENSION.resolve("test"))) {
      tests =
          files
              .map(file -> "test/" + file.getFileName())
              .filter(name -> name.endsWith(".test.js") && !name.equals(CLIENT))
              .sorted()
              .toList();
    }
    assertTrue(tests.size() > 4, tests::toString);
    assertAllPass(node(Stream.concat(Stream.of("--test"), tests.stream())));
  }

  @Test
  void clientOfTheLanguageServer() throws Exception {
    assumeMade();
    assertAllPass(node(Stream.of("--test", CLIENT)));
  }

  private static void assertAllPass(String said) {
    assertTrue(said.contains("# fail 0") && !said.contains("# pass 0"), said);
  }

  @Test
  void inAWorkbench() throws Exception {
    assumeTrue(Thorough.IS_ON, "run in the profile 'thorough'");
    for (String program : List.of("node", "npm", "chromium", "chromedriver", "rg")) {
      assumeTrue(isThere(program), "there is no " + program);
    }
    assumeMade();
    String said = run(List.of("workbench/run"), Map.of());
    assertTrue(said.contains("all is well"), said);
  }

  private static boolean isThere(String program) {
    return Stream.of(System.getenv("PATH").split(":", -1))
        .anyMatch(path -> Files.isExecutable(Path.of(path, program)));
  }

  /** Skips a test where the build could not make the extension. */
  private static void assumeMade() throws IOException {
    try (Stream<Path> files = Files.list(EXTENSION.resolve("target"))) {
      Optional<Path> missing =
          files.filter(file -> file.toString().endsWith(".missing")).findFirst();
      if (missing.isPresent()) {
        assumeTrue(false, "the extension was not made: " + Files.readString(missing.get()).strip());
      }
    }
  }

  /** Returns what Node prints; fails if it fails. */
  private String node(Stream<String> arguments) throws IOException, InterruptedException {
    assumeTrue(isThere("node"), "there is no Node");
    return run(
        Stream.concat(Stream.of("node"), arguments).toList(),
        Map.of("NODE_PATH", PACKAGES.toString()));
  }

  private String run(List<String> command, Map<String, String> environment)
      throws IOException, InterruptedException {
    Path out = folder.resolve("out");
    ProcessBuilder builder =
        new ProcessBuilder(command)
            .directory(EXTENSION.toFile())
            .redirectErrorStream(true)
            .redirectOutput(out.toFile());
    builder.environment().putAll(environment);
    int code = builder.start().waitFor();
    String printed = Files.readString(out);
    assertEquals(0, code, printed);
    return printed;
  }

  private static ZipFile archive() throws IOException {
    assumeMade();
    try (Stream<Path> files = Files.list(EXTENSION.resolve("target"))) {
      Path archive =
          files.filter(file -> file.toString().endsWith(".vsix")).findFirst().orElseThrow();
      return new ZipFile(archive.toFile());
    }
  }

  private static String read(ZipFile archive, String name) throws IOException {
    ZipEntry entry = archive.getEntry(name);
    assertTrue(entry != null, name);
    try (InputStream content = archive.getInputStream(entry)) {
      return new String(content.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
