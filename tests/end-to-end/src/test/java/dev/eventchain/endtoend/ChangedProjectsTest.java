package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.Projects;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests {@code bundles/front/ci} with projects, with the real program, and against the files of the
 * build servers that call it.
 */
class ChangedProjectsTest {

  @TempDir Path folder;
  private ModelRepository repository;

  @BeforeEach
  void makeARepository() throws Exception {
    repository = ModelRepository.in(folder);
  }

  @Test
  void aProjectIsCheckedIfAFileThatItRefersToHasChanged() throws Exception {
    repository.write("shop/eventchain.yaml", "name: shop\n");
    repository.write("shop/m.xmi", ModelRepository.shop("M", "<branch href=\"../x.lib#/\"/>"));
    repository.write("x.lib", ModelRepository.shop("X", ""));
    repository.write("types/y.txt", "");
    repository.commit("two");
    repository.run("validate-models", "--project=shop", "x.lib").expect(0).says("<validate><shop>");
    repository.runIn("shop", "--project=.", "../x.lib").expect(0).says("<validate><.>");
    repository
        .run("validate-models", "--project=shop", "types/y.txt")
        .expect(0)
        .says("nothing was checked");
    repository.write("shop/eventchain.yaml", "messages: ../types\n");
    repository.commit("three");
    repository
        .run("validate-models", "--project=shop", "types/y.txt")
        .expect(0)
        .says("<validate><shop>");
  }

  @Test
  void aProjectIsCheckedIfAFileInItHasChanged() throws Exception {
    repository.write("my project/eventchain.yaml", "name: shop\n");
    repository.write("my project/out/a.json", "");
    repository.commit("two");
    String project = "--project=my project";
    repository.run("validate-models", project).expect(0).says("<validate><my project>");
    repository
        .run("validate-models", project, "a.xmi")
        .expect(0)
        .says("no file of 'my project' has changed");
    repository
        .run("validate-models", project, "my project/out/a.json")
        .expect(0)
        .says("nothing was checked");
    repository
        .run("validate-models", project, "--since=HEAD~1")
        .expect(0)
        .says("<validate><my project>");
  }

  @Test
  void theModelOfAProjectIsValidatedAsTheProject() throws Exception {
    repository.write("my car/brake/eventchain.yaml", "name: brake\n");
    repository.write("my car/brake/model/chain.xmi", ModelRepository.shop("C", ""));
    repository.write("my car/brake/bench.yaml", "");
    repository.write("designed/eventchain.yaml", "name: designed\n");
    repository.commit("two");
    repository
        .run("validate-models")
        .expect(0)
        .says("4 of 4 models")
        .says("<validate><a.xmi><my car/brake><refers.xmi>")
        .says("'designed' has no model/chain.xmi and is not checked (--project=designed)");
    repository
        .run("validate-models", "my car/brake/bench.yaml")
        .expect(0)
        .says("<validate><my car/brake>");
    repository.run("validate-models", "a.xmi").expect(0).says("<validate><a.xmi>");
    repository.runIn("my car/brake").expect(0).says("<validate><.>");
    repository
        .run("validate-models", "--metamodel=shop.ecore")
        .expect(0)
        .says("<a.xmi><my car/brake/model/chain.xmi><refers.xmi>");
    repository.write("my car/brake/out/a.json", "");
    repository.commit("three");
    repository.run("validate-models", "--since=HEAD~1").expect(0).says("nothing was checked");
  }

  @Test
  void aVerdictIsAboutAProject() throws Exception {
    repository.write("brake/eventchain.yaml", "name: brake\n");
    repository.commit("two");
    repository
        .run("validate-models", "--verdict", "--project=brake", "--format=json")
        .expect(0)
        .says("<run><--format=json><brake>");
    repository.run("validate-models", "--verdict").expect(2).says("--project=FOLDER --verdict");
    repository.set("PROJECT", "brake");
    repository.set("VERDICT", "true");
    repository.run("from-inputs").expect(0).says("<run><brake>");
    repository.set("VERDICT", "yes");
    repository.run("from-inputs").expect(2).says("VERDICT is 'yes'");
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
    repository.call("real", new Program().script());
    Projects.copy(Program.ROOT.resolve("examples/radar-aeb"), repository.path("brake"));
    repository.git("rm", "-q", "-r", "a.xmi", "refers.xmi", "with blanks");
    repository.commit("two");
    repository.run("validate-models").expect(0).says("0 errors, 0 warnings");
  }

  @Test
  void theRealProgramWritesReportsOfABadModel() throws Exception {
    repository.call("real", new Program().script());
    repository.set("SINCE", "HEAD");
    repository.set("OPTIONS", "--metamodel=shop.ecore\n--ocl=rules.ocl\n");
    repository.set("SARIF", "reports/findings.sarif");
    repository.set("JUNIT", "reports/findings.xml");
    repository.write("rules.ocl", "context Shop inv Named: self.name <> ''\n");
    repository.commit("two");
    repository.write("with blanks/b 1.xmi", ModelRepository.shop("", ""));
    repository
        .run("from-inputs")
        .expect(1)
        .says("with blanks/b 1.xmi:2:")
        .says("[ocl.violated Shop::Named]");
    String sarif = Files.readString(repository.path("reports/findings.sarif"));
    JsonNode results = new ObjectMapper().readTree(sarif).at("/runs/0/results");
    assertEquals(1, results.size(), sarif);
    assertEquals("ocl.violated/Shop::Named", results.at("/0/ruleId").asText());
    assertEquals(
        "with%20blanks/b%201.xmi",
        results.at("/0/locations/0/physicalLocation/artifactLocation/uri").asText());
    String junit = Files.readString(repository.path("reports/findings.xml"));
    assertTrue(junit.contains("failures=\"1\""), junit);
    repository.write("with blanks/b 1.xmi", ModelRepository.shop("B3", ""));
    repository.run("from-inputs").expect(0);
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
      assertTrue(Files.isExecutable(ModelRepository.SCRIPTS.resolve(script)), script);
    }
  }
}
