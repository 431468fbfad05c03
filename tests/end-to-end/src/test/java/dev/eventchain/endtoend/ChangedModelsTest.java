package dev.eventchain.endtoend;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static java.nio.charset.StandardCharsets.UTF_16;
import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.Projects;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests {@code bundles/front/ci}, which build servers and pre-commit call, in repositories created
 * for it.
 */
class ChangedModelsTest {

  private static final Path SCRIPTS = Program.ROOT.resolve("bundles/front/ci");

  private static final String METAMODEL =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <ecore:EPackage xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI"
          xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
          xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore"
          name="shop" nsURI="http://example.org/shop" nsPrefix="shop">
        <eClassifiers xsi:type="ecore:EClass" name="Shop">
          <eStructuralFeatures xsi:type="ecore:EAttribute" name="name"
              eType="ecore:EDataType http://www.eclipse.org/emf/2002/Ecore#//EString"/>
          <eStructuralFeatures xsi:type="ecore:EReference" name="branch" eType="#//Shop"/>
        </eClassifiers>
      </ecore:EPackage>
      """;

  /** Script that prints its arguments, and ends with the exit code in the file {@code code}. */
  private static final String FAKE =
      """
      #!/usr/bin/env bash
      printf '<%s>' "$@"
      [ ! -f code ] || exit "$(cat code)"
      """;

  @TempDir Path folder;
  private Path repository;
  private final Map<String, String> environment = new TreeMap<>();

  @BeforeEach
  void makeARepository() throws Exception {
    repository = Files.createDirectory(folder.resolve("a repository"));
    git("init", "-q", "-b", "main");
    write("shop.ecore", METAMODEL);
    write("a.xmi", shop("A", ""));
    write("with blanks/b 1.xmi", shop("B", ""));
    write("refers.xmi", shop("R", "<branch href=\"with%20blanks/b%201.xmi#/\"/>"));
    commit("one");
    environment.put("EVENTCHAIN", program("fake", FAKE).toString());
  }

  @Test
  void allModelsAreCheckedWithoutARevision() throws Exception {
    String all = "<validate><a.xmi><refers.xmi><with blanks/b 1.xmi>";
    run("validate-models").expect(0).says("3 of 3 models").says(all);
    run("validate-models", "--since=").expect(0).says(all);
    run("validate-models", "--models=with*").expect(0).says("<validate><with blanks/b 1.xmi>");
  }

  @Test
  void changedModelsAreFoundWithThoseThatReferToThem() throws Exception {
    write("a.xmi", shop("A2", ""));
    commit("two");
    run("validate-models", "--since=HEAD~1").expect(0).says("1 of 3").says("<validate><a.xmi>");
    write("with blanks/b 1.xmi", shop("B2", ""));
    run("validate-models", "--since=HEAD")
        .expect(0)
        .says("2 of 3 models")
        .says("<validate><refers.xmi><with blanks/b 1.xmi>");
  }

  @Test
  void deletedModelsAreLeftOutAndThoseThatReferToThemAreChecked() throws Exception {
    git("rm", "-q", "with blanks/b 1.xmi", "a.xmi");
    commit("two");
    run("validate-models", "--since=HEAD~1")
        .expect(0)
        .says("1 of 1 models")
        .says("<validate><refers.xmi>");
    git("mv", "refers.xmi", "renamed.xmi");
    run("validate-models", "--since=HEAD").expect(0).says("<validate><renamed.xmi>");
  }

  @Test
  void aChangedMetamodelOrConstraintConcernsAllModels() throws Exception {
    write("sub/rules.ocl", "");
    git("add", ".");
    run("validate-models", "--since=HEAD").expect(0).says("3 of 3 models");
    run("validate-models", "shop.ecore").expect(0).says("3 of 3 models");
    write("ä.xmi", shop("A", ""));
    commit("two");
    run("validate-models", "ä.xmi").expect(0).says("4 of 4 models");
  }

  @Test
  void nothingThatMattersHasChangedIsSaid() throws Exception {
    Path outputs = Files.createFile(folder.resolve("outputs"));
    environment.put("GITHUB_OUTPUT", outputs.toString());
    run("validate-models", "--since=HEAD").expect(0).says("nothing was checked: no file has");
    write("notes.txt", "");
    commit("two");
    Program.Ended ended = run("validate-models", "--since=HEAD~1").expect(0);
    ended.says("nothing was checked: no model has changed.");
    assertFalse(ended.out().contains("<validate>"));
    run("validate-models", "a.xmi").expect(0);
    assertEquals("checked=false\nchecked=false\nchecked=true\n", Files.readString(outputs));
  }

  @Test
  void whatCannotBeDecidedFails() throws Exception {
    run("validate-models", "--since=nowhere").expect(2).says("no revision 'nowhere'");
    run("validate-models", "--since=HEAD", "a.xmi").expect(2).says("not both");
    run("validate-models", "--models=*.uml").expect(2).says("no file in git matches *.uml");
    run("validate-models", "--ocl", "rules.ocl").expect(2).says("needs the form --name=value");
    run("validate-models", "--project=sub").expect(2).says("has no eventchain.yaml");
    git("checkout", "-q", "--orphan", "other");
    commit("other");
    run("validate-models", "--since=main").expect(2).says("no common history");
    Files.move(repository.resolve(".git"), folder.resolve("gone"));
    run("validate-models").expect(2).says("this is not a git repository");
  }

  @Test
  void filesMayBeWrittenInAnyWay() throws Exception {
    write("my project/eventchain.yaml", "name: shop\n");
    commit("two");
    for (String path : List.of("./a.xmi", "sub/../a.xmi", repository.resolve("a.xmi").toString())) {
      run("validate-models", path).expect(0).says("<validate><a.xmi>");
    }
    for (String path : List.of("./my project", repository.resolve("my project").toString())) {
      String[] arguments = {"--project=" + path, "--since=HEAD~1"};
      run("validate-models", arguments).expect(0).says("<validate><my project>");
    }
  }

  @Test
  void aFileThatGitDoesNotKnowIsNotSaidToBeUnchanged() throws Exception {
    write("new.xmi", shop("N", ""));
    for (String path : List.of("new.xmi", "nowhere.xmi", "../outside.xmi")) {
      run("validate-models", path).expect(2).says("'" + path + "' is not a file in git");
    }
  }

  @Test
  void aChangedFileThatAnOptionNamesConcernsAllModels() throws Exception {
    write("rules.txt", "");
    write("types/Price.txt", "");
    commit("two");
    run("validate-models", "--since=HEAD~1").expect(0).says("nothing was checked");
    run("validate-models", "--since=HEAD~1", "--ocl=./rules.txt").expect(0).says("3 of 3 models");
    run("validate-models", "types/Price.txt", "--messages=types/").expect(0).says("3 of 3 models");
  }

  @Test
  void changesOutsideTheCurrentFolderCount() throws Exception {
    write("models/m.xmi", shop("M", "<branch href=\"../lib/x.lib#/\"/>"));
    write("lib/x.lib", shop("X", ""));
    commit("two");
    write("shop.ecore", METAMODEL + "\n");
    runIn("models", "--since=HEAD").expect(0).says("1 of 1 models").says("<validate><m.xmi>");
    git("checkout", "-q", "shop.ecore");
    runIn("models", "--since=HEAD").expect(0).says("nothing was checked: no file has changed");
    write("lib/x.lib", shop("X2", ""));
    runIn("models", "--since=HEAD").expect(0).says("<validate><m.xmi>");
    runIn("models", "../lib/x.lib").expect(0).says("<validate><m.xmi>");
    runIn("models", "--since=HEAD", "--ocl=../lib/x.lib").expect(0).says("1 of 1 models");
    runIn("models", "../lib").expect(2).says("'../lib' is not a file in git");
  }

  @Test
  void aPatternThatMatchesNothingFails() throws Exception {
    write("a.xmi", shop("A2", ""));
    for (String narrowing : List.of("--since=HEAD", "a.xmi")) {
      run("validate-models", narrowing, "--models=*.uml").expect(2).says("matches *.uml");
      run("validate-models", narrowing, "--models=*.xmi", "--models=*.uml").expect(2);
    }
    git("rm", "-q", "-f", "*.xmi");
    run("validate-models", "--since=HEAD").expect(0).says("nothing was checked");
    run("validate-models", "--since=HEAD", "--models=*.xmi").expect(2);
    run("validate-models").expect(2).says("no file in git matches *.xmi");
  }

  @Test
  void modelsThatAreMissingInTheWorkingTreeAreAnError() throws Exception {
    Files.createSymbolicLink(repository.resolve("link.xmi"), Path.of("nowhere.xmi"));
    commit("two");
    Files.delete(repository.resolve("refers.xmi"));
    String missing =
        "2 of 4 models in git are missing in the working tree; the first is 'link.xmi'";
    for (String narrowing : List.of("--since=", "--since=HEAD", "a.xmi")) {
      run("validate-models", narrowing).expect(2).says(missing);
    }
    git("checkout", "-q", "refers.xmi");
    git("rm", "-q", "link.xmi");
    git("update-index", "--skip-worktree", "a.xmi");
    Files.delete(repository.resolve("a.xmi"));
    run("validate-models", "--since=HEAD").expect(2).says("the first is 'a.xmi'");
  }

  @Test
  void changesAreFollowedThroughFilesThatAreNoModels() throws Exception {
    write("top.xmi", shop("T", "<branch href=\"mid.lib#/\"/>"));
    write("mid.lib", shop("M", "<branch href=\"deep/leaf.lib#/\"/>"));
    write("deep/leaf.lib", shop("L", ""));
    Files.createSymbolicLink(repository.resolve("link.xmi"), Path.of("deep/leaf.lib"));
    commit("two");
    write("deep/leaf.lib", shop("L2", ""));
    String both = "<validate><link.xmi><top.xmi>";
    run("validate-models", "--since=HEAD").expect(0).says("2 of 5 models").says(both);
    run("validate-models", "deep/leaf.lib").expect(0).says(both);
    run("validate-models", "mid.lib").expect(0).says("1 of 5 models").says("<validate><top.xmi>");
  }

  @Test
  void modelsInWhichNamesCannotBeSearchedAreCheckedWithAnyChange() throws Exception {
    write("x.lib", shop("X", ""));
    commit("two");
    for (String written : List.of("%78.lib", "&#120;.lib", "&#x78;.lib", "x&#46;lib", "&#x002E;")) {
      assertCheckedWithAnyChange(shop("E", written).getBytes(UTF_8), written);
    }
    assertCheckedWithAnyChange(shop("E", "x.lib").getBytes(UTF_16), "UTF-16");
    assertCheckedWithAnyChange(shop("\u00e4", "x.lib").getBytes(ISO_8859_1), "ISO-8859-1");
    Files.write(repository.resolve("odd.xmi"), shop("E", "&#10;%20 ä").getBytes(UTF_8));
    commit("three");
    run("validate-models", "x.lib").expect(0).says("nothing was checked");
  }

  private void assertCheckedWithAnyChange(byte[] model, String message) throws Exception {
    Files.write(repository.resolve("odd.xmi"), model);
    commit(message);
    run("validate-models", "x.lib").expect(0).says("1 of 4 models").says("<validate><odd.xmi>");
  }

  @Test
  void aProjectIsCheckedIfAFileThatItRefersToHasChanged() throws Exception {
    write("shop/eventchain.yaml", "name: shop\n");
    write("shop/m.xmi", shop("M", "<branch href=\"../x.lib#/\"/>"));
    write("x.lib", shop("X", ""));
    write("types/y.txt", "");
    commit("two");
    run("validate-models", "--project=shop", "x.lib").expect(0).says("<validate><shop>");
    runIn("shop", "--project=.", "../x.lib").expect(0).says("<validate><.>");
    run("validate-models", "--project=shop", "types/y.txt").expect(0).says("nothing was checked");
    write("shop/eventchain.yaml", "messages: ../types\n");
    commit("three");
    run("validate-models", "--project=shop", "types/y.txt").expect(0).says("<validate><shop>");
  }

  @Test
  void whatKeepsItFromRunningIsNamed() throws Exception {
    Path outputs = Files.createFile(folder.resolve("outputs"));
    environment.put("GITHUB_OUTPUT", outputs.toString());
    environment.put("TMPDIR", folder.resolve("nowhere").toString());
    run("validate-models").expect(2).says("no temporary file can be made in '");
    environment.remove("TMPDIR");
    environment.put("EVENTCHAIN", "no-such-program");
    run("validate-models").expect(2).says("there is no program 'no-such-program'");
    environment.put("EVENTCHAIN", program("broken", "#!/no/such/shell\n").toString());
    run("validate-models").expect(2).says("could not be run");
    assertEquals("", Files.readString(outputs));
    git("update-ref", "-d", "HEAD");
    run("validate-models", "--since=main").expect(2).says("this branch has no commits");
  }

  @Test
  void exitCodesAreThoseOfTheProgram() throws Exception {
    for (int code = 0; code < 5; code++) {
      write("code", Integer.toString(code));
      run("validate-models", "a.xmi").expect(code);
    }
  }

  @Test
  void aProjectIsCheckedIfAFileInItHasChanged() throws Exception {
    write("my project/eventchain.yaml", "name: shop\n");
    write("my project/out/a.json", "");
    commit("two");
    String project = "--project=my project";
    run("validate-models", project).expect(0).says("<validate><my project>");
    run("validate-models", project, "a.xmi").expect(0).says("no file of 'my project' has changed");
    run("validate-models", project, "my project/out/a.json").expect(0).says("nothing was checked");
    run("validate-models", project, "--since=HEAD~1").expect(0).says("<validate><my project>");
  }

  @Test
  void theModelOfAProjectIsValidatedAsTheProject() throws Exception {
    write("my car/brake/eventchain.yaml", "name: brake\n");
    write("my car/brake/model/chain.xmi", shop("C", ""));
    write("my car/brake/bench.yaml", "");
    write("designed/eventchain.yaml", "name: designed\n");
    commit("two");
    run("validate-models")
        .expect(0)
        .says("4 of 4 models")
        .says("<validate><a.xmi><my car/brake><refers.xmi>")
        .says("'designed' has no model/chain.xmi and is not checked (--project=designed)");
    run("validate-models", "my car/brake/bench.yaml").expect(0).says("<validate><my car/brake>");
    run("validate-models", "a.xmi").expect(0).says("<validate><a.xmi>");
    runIn("my car/brake").expect(0).says("<validate><.>");
    run("validate-models", "--metamodel=shop.ecore")
        .expect(0)
        .says("<a.xmi><my car/brake/model/chain.xmi><refers.xmi>");
    write("my car/brake/out/a.json", "");
    commit("three");
    run("validate-models", "--since=HEAD~1").expect(0).says("nothing was checked");
  }

  @Test
  void aVerdictIsAboutAProject() throws Exception {
    write("brake/eventchain.yaml", "name: brake\n");
    commit("two");
    run("validate-models", "--verdict", "--project=brake", "--format=json")
        .expect(0)
        .says("<run><--format=json><brake>");
    run("validate-models", "--verdict").expect(2).says("--project=FOLDER --verdict");
    environment.put("PROJECT", "brake");
    environment.put("VERDICT", "true");
    run("from-inputs").expect(0).says("<run><brake>");
    environment.put("VERDICT", "yes");
    run("from-inputs").expect(2).says("VERDICT is 'yes'");
  }

  @Test
  void theHookIsCalledForAllFilesOfAProject() throws IOException {
    String hook = Files.readString(Program.ROOT.resolve(".pre-commit-hooks.yaml"));
    String folded = hook.replaceFirst("(?s).*files: >-\n(.*?)\n  require_serial.*", "$1");
    Pattern files = Pattern.compile(folded.replaceAll("\\s+", " ").strip());
    Path example = Program.ROOT.resolve("examples/radar-aeb");
    try (Stream<Path> all = Files.walk(example)) {
      for (Path file : all.filter(Files::isRegularFile).toList()) {
        String name = "p/" + example.relativize(file);
        boolean isResult = name.startsWith("p/out/");
        assertTrue(isResult || files.matcher(name).find(), name);
      }
    }
    for (String name : List.of("faults.yaml", "tests/A.yaml", "shop.ecore", "a/b/t.mtl")) {
      assertTrue(files.matcher(name).find(), name);
    }
    for (String name : List.of("README.md", "src/a.py", "bench.yaml.orig", "tests/a.py")) {
      assertFalse(files.matcher(name).find(), name);
    }
  }

  @Test
  void theRealProgramFindsNothingInASoundProject() throws Exception {
    environment.put("EVENTCHAIN", program("real", new Program().script()).toString());
    Projects.copy(Program.ROOT.resolve("examples/radar-aeb"), repository.resolve("brake"));
    git("rm", "-q", "-r", "a.xmi", "refers.xmi", "with blanks");
    commit("two");
    run("validate-models").expect(0).says("0 errors, 0 warnings");
  }

  @Test
  void theRealProgramWritesReportsOfABadModel() throws Exception {
    environment.put("EVENTCHAIN", program("real", new Program().script()).toString());
    environment.put("SINCE", "HEAD");
    environment.put("OPTIONS", "--metamodel=shop.ecore\n--ocl=rules.ocl\n");
    environment.put("SARIF", "reports/findings.sarif");
    environment.put("JUNIT", "reports/findings.xml");
    write("rules.ocl", "context Shop inv Named: self.name <> ''\n");
    commit("two");
    write("with blanks/b 1.xmi", shop("", ""));
    run("from-inputs").expect(1).says("with blanks/b 1.xmi:2:").says("[ocl.violated Shop::Named]");
    String sarif = Files.readString(repository.resolve("reports/findings.sarif"));
    JsonNode results = new ObjectMapper().readTree(sarif).at("/runs/0/results");
    assertEquals(1, results.size(), sarif);
    assertEquals("ocl.violated/Shop::Named", results.at("/0/ruleId").asText());
    assertEquals(
        "with%20blanks/b%201.xmi",
        results.at("/0/locations/0/physicalLocation/artifactLocation/uri").asText());
    String junit = Files.readString(repository.resolve("reports/findings.xml"));
    assertTrue(junit.contains("failures=\"1\""), junit);
    write("with blanks/b 1.xmi", shop("B3", ""));
    run("from-inputs").expect(0);
  }

  @Test
  void theFilesOfTheBuildServersCallScriptsThatAreThere() throws IOException {
    for (String caller : List.of("bundles/front/ci/action.yml", "bundles/front/ci/gitlab-ci.yml")) {
      String text = Files.readString(Program.ROOT.resolve(caller));
      assertTrue(text.contains("/from-inputs\"'"), caller);
    }
    String hook = Files.readString(Program.ROOT.resolve(".pre-commit-hooks.yaml"));
    assertTrue(hook.contains("entry: bundles/front/ci/validate-models\n"), hook);
    for (String script : List.of("from-inputs", "validate-models")) {
      assertTrue(Files.isExecutable(SCRIPTS.resolve(script)), script);
    }
  }

  private static String shop(String name, String content) {
    return """
    <?xml version="1.0" encoding="UTF-8"?>
    <shop:Shop xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI"
        xmlns:shop="http://example.org/shop" name="%s">%s</shop:Shop>
    """
        .formatted(name, content);
  }

  private void write(String name, String text) throws IOException {
    Path file = repository.resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }

  private Path program(String name, String text) throws IOException {
    Path file = Files.writeString(folder.resolve(name), text);
    assertTrue(file.toFile().setExecutable(true));
    return file;
  }

  private void commit(String message) throws Exception {
    git("add", "-A");
    git("commit", "-q", "-m", message);
  }

  private void git(String... arguments) throws Exception {
    List<String> command = new ArrayList<>(List.of("git"));
    for (String setting : List.of("user.name=a", "user.email=a@b", "commit.gpgsign=false")) {
      command.addAll(List.of("-c", setting));
    }
    Stream.of(arguments).forEach(command::add);
    ended(command, repository).expect(0);
  }

  private Program.Ended run(String script, String... arguments) throws Exception {
    return runIn(repository, script, arguments);
  }

  private Program.Ended runIn(String name, String... arguments) throws Exception {
    return runIn(repository.resolve(name), "validate-models", arguments);
  }

  private Program.Ended runIn(Path current, String script, String[] arguments) throws Exception {
    List<String> command = new ArrayList<>(List.of(SCRIPTS.resolve(script).toString()));
    command.addAll(List.of(arguments));
    return ended(command, current);
  }

  private Program.Ended ended(List<String> command, Path current) throws Exception {
    Path out = folder.resolve("out");
    Path err = folder.resolve("err");
    ProcessBuilder builder = new ProcessBuilder(command).directory(current.toFile());
    builder.environment().keySet().removeIf(name -> name.startsWith("GIT"));
    builder.environment().putAll(environment);
    int code = builder.redirectOutput(out.toFile()).redirectError(err.toFile()).start().waitFor();
    return new Program.Ended(code, Files.readString(out), Files.readString(err));
  }
}
