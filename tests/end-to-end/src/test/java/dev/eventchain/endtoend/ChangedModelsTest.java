package dev.eventchain.endtoend;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static java.nio.charset.StandardCharsets.UTF_16;
import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests {@code bundles/front/ci}, which build servers and pre-commit call, in repositories created
 * for it.
 */
class ChangedModelsTest {

  @TempDir Path folder;
  private ModelRepository repository;

  @BeforeEach
  void makeARepository() throws Exception {
    repository = ModelRepository.in(folder);
  }

  @Test
  void allModelsAreCheckedWithoutARevision() throws Exception {
    String all = "<validate><a.xmi><refers.xmi><with blanks/b 1.xmi>";
    repository.run("validate-models").expect(0).says("3 of 3 models").says(all);
    repository.run("validate-models", "--since=").expect(0).says(all);
    repository
        .run("validate-models", "--models=with*")
        .expect(0)
        .says("<validate><with blanks/b 1.xmi>");
  }

  @Test
  void changedModelsAreFoundWithThoseThatReferToThem() throws Exception {
    repository.write("a.xmi", ModelRepository.shop("A2", ""));
    repository.commit("two");
    repository
        .run("validate-models", "--since=HEAD~1")
        .expect(0)
        .says("1 of 3")
        .says("<validate><a.xmi>");
    repository.write("with blanks/b 1.xmi", ModelRepository.shop("B2", ""));
    repository
        .run("validate-models", "--since=HEAD")
        .expect(0)
        .says("2 of 3 models")
        .says("<validate><refers.xmi><with blanks/b 1.xmi>");
  }

  @Test
  void deletedModelsAreLeftOutAndThoseThatReferToThemAreChecked() throws Exception {
    repository.git("rm", "-q", "with blanks/b 1.xmi", "a.xmi");
    repository.commit("two");
    repository
        .run("validate-models", "--since=HEAD~1")
        .expect(0)
        .says("1 of 1 models")
        .says("<validate><refers.xmi>");
    repository.git("mv", "refers.xmi", "renamed.xmi");
    repository.run("validate-models", "--since=HEAD").expect(0).says("<validate><renamed.xmi>");
  }

  @Test
  void aChangedMetamodelOrConstraintConcernsAllModels() throws Exception {
    repository.write("sub/rules.ocl", "");
    repository.git("add", ".");
    repository.run("validate-models", "--since=HEAD").expect(0).says("3 of 3 models");
    repository.run("validate-models", "shop.ecore").expect(0).says("3 of 3 models");
    repository.write("ä.xmi", ModelRepository.shop("A", ""));
    repository.commit("two");
    repository.run("validate-models", "ä.xmi").expect(0).says("4 of 4 models");
  }

  @Test
  void nothingThatMattersHasChangedIsSaid() throws Exception {
    Path outputs = Files.createFile(folder.resolve("outputs"));
    repository.set("GITHUB_OUTPUT", outputs.toString());
    repository
        .run("validate-models", "--since=HEAD")
        .expect(0)
        .says("nothing was checked: no file has");
    repository.write("notes.txt", "");
    repository.commit("two");
    Program.Ended ended = repository.run("validate-models", "--since=HEAD~1").expect(0);
    ended.says("nothing was checked: no model has changed.");
    assertFalse(ended.out().contains("<validate>"));
    repository.run("validate-models", "a.xmi").expect(0);
    assertEquals("checked=false\nchecked=false\nchecked=true\n", Files.readString(outputs));
  }

  @Test
  void whatCannotBeDecidedFails() throws Exception {
    repository.run("validate-models", "--since=nowhere").expect(2).says("no revision 'nowhere'");
    repository.run("validate-models", "--since=HEAD", "a.xmi").expect(2).says("not both");
    repository
        .run("validate-models", "--models=*.uml")
        .expect(2)
        .says("no file in git matches *.uml");
    repository
        .run("validate-models", "--ocl", "rules.ocl")
        .expect(2)
        .says("needs the form --name=value");
    repository.run("validate-models", "--project=sub").expect(2).says("has no eventchain.yaml");
    repository.git("checkout", "-q", "--orphan", "other");
    repository.commit("other");
    repository.run("validate-models", "--since=main").expect(2).says("no common history");
    Files.move(repository.path(".git"), folder.resolve("gone"));
    repository.run("validate-models").expect(2).says("this is not a git repository");
  }

  @Test
  void filesMayBeWrittenInAnyWay() throws Exception {
    repository.write("my project/eventchain.yaml", "name: shop\n");
    repository.commit("two");
    for (String path : List.of("./a.xmi", "sub/../a.xmi", repository.path("a.xmi").toString())) {
      repository.run("validate-models", path).expect(0).says("<validate><a.xmi>");
    }
    for (String path : List.of("./my project", repository.path("my project").toString())) {
      String[] arguments = {"--project=" + path, "--since=HEAD~1"};
      repository.run("validate-models", arguments).expect(0).says("<validate><my project>");
    }
  }

  @Test
  void aFileThatGitDoesNotKnowIsNotSaidToBeUnchanged() throws Exception {
    repository.write("new.xmi", ModelRepository.shop("N", ""));
    for (String path : List.of("new.xmi", "nowhere.xmi", "../outside.xmi")) {
      repository.run("validate-models", path).expect(2).says("'" + path + "' is not a file in git");
    }
  }

  @Test
  void aChangedFileThatAnOptionNamesConcernsAllModels() throws Exception {
    repository.write("rules.txt", "");
    repository.write("types/Price.txt", "");
    repository.commit("two");
    repository.run("validate-models", "--since=HEAD~1").expect(0).says("nothing was checked");
    repository
        .run("validate-models", "--since=HEAD~1", "--ocl=./rules.txt")
        .expect(0)
        .says("3 of 3 models");
    repository
        .run("validate-models", "types/Price.txt", "--messages=types/")
        .expect(0)
        .says("3 of 3 models");
  }

  @Test
  void changesOutsideTheCurrentFolderCount() throws Exception {
    repository.write(
        "models/m.xmi", ModelRepository.shop("M", "<branch href=\"../lib/x.lib#/\"/>"));
    repository.write("lib/x.lib", ModelRepository.shop("X", ""));
    repository.commit("two");
    repository.write("shop.ecore", ModelRepository.METAMODEL + "\n");
    repository
        .runIn("models", "--since=HEAD")
        .expect(0)
        .says("1 of 1 models")
        .says("<validate><m.xmi>");
    repository.git("checkout", "-q", "shop.ecore");
    repository
        .runIn("models", "--since=HEAD")
        .expect(0)
        .says("nothing was checked: no file has changed");
    repository.write("lib/x.lib", ModelRepository.shop("X2", ""));
    repository.runIn("models", "--since=HEAD").expect(0).says("<validate><m.xmi>");
    repository.runIn("models", "../lib/x.lib").expect(0).says("<validate><m.xmi>");
    repository
        .runIn("models", "--since=HEAD", "--ocl=../lib/x.lib")
        .expect(0)
        .says("1 of 1 models");
    repository.runIn("models", "../lib").expect(2).says("'../lib' is not a file in git");
  }

  @Test
  void aPatternThatMatchesNothingFails() throws Exception {
    repository.write("a.xmi", ModelRepository.shop("A2", ""));
    for (String narrowing : List.of("--since=HEAD", "a.xmi")) {
      repository
          .run("validate-models", narrowing, "--models=*.uml")
          .expect(2)
          .says("matches *.uml");
      repository.run("validate-models", narrowing, "--models=*.xmi", "--models=*.uml").expect(2);
    }
    repository.git("rm", "-q", "-f", "*.xmi");
    repository.run("validate-models", "--since=HEAD").expect(0).says("nothing was checked");
    repository.run("validate-models", "--since=HEAD", "--models=*.xmi").expect(2);
    repository.run("validate-models").expect(2).says("no file in git matches *.xmi");
  }

  @Test
  void modelsThatAreMissingInTheWorkingTreeAreAnError() throws Exception {
    Files.createSymbolicLink(repository.path("link.xmi"), Path.of("nowhere.xmi"));
    repository.commit("two");
    Files.delete(repository.path("refers.xmi"));
    String missing =
        "2 of 4 models in git are missing in the working tree; the first is 'link.xmi'";
    for (String narrowing : List.of("--since=", "--since=HEAD", "a.xmi")) {
      repository.run("validate-models", narrowing).expect(2).says(missing);
    }
    repository.git("checkout", "-q", "refers.xmi");
    repository.git("rm", "-q", "link.xmi");
    repository.git("update-index", "--skip-worktree", "a.xmi");
    Files.delete(repository.path("a.xmi"));
    repository.run("validate-models", "--since=HEAD").expect(2).says("the first is 'a.xmi'");
  }

  @Test
  void changesAreFollowedThroughFilesThatAreNoModels() throws Exception {
    repository.write("top.xmi", ModelRepository.shop("T", "<branch href=\"mid.lib#/\"/>"));
    repository.write("mid.lib", ModelRepository.shop("M", "<branch href=\"deep/leaf.lib#/\"/>"));
    repository.write("deep/leaf.lib", ModelRepository.shop("L", ""));
    Files.createSymbolicLink(repository.path("link.xmi"), Path.of("deep/leaf.lib"));
    repository.commit("two");
    repository.write("deep/leaf.lib", ModelRepository.shop("L2", ""));
    String both = "<validate><link.xmi><top.xmi>";
    repository.run("validate-models", "--since=HEAD").expect(0).says("2 of 5 models").says(both);
    repository.run("validate-models", "deep/leaf.lib").expect(0).says(both);
    repository
        .run("validate-models", "mid.lib")
        .expect(0)
        .says("1 of 5 models")
        .says("<validate><top.xmi>");
  }

  @Test
  void modelsInWhichNamesCannotBeSearchedAreCheckedWithAnyChange() throws Exception {
    repository.write("x.lib", ModelRepository.shop("X", ""));
    repository.commit("two");
    for (String written : List.of("%78.lib", "&#120;.lib", "&#x78;.lib", "x&#46;lib", "&#x002E;")) {
      assertCheckedWithAnyChange(ModelRepository.shop("E", written).getBytes(UTF_8), written);
    }
    assertCheckedWithAnyChange(ModelRepository.shop("E", "x.lib").getBytes(UTF_16), "UTF-16");
    assertCheckedWithAnyChange(
        ModelRepository.shop("\u00e4", "x.lib").getBytes(ISO_8859_1), "ISO-8859-1");
    Files.write(
        repository.path("odd.xmi"), ModelRepository.shop("E", "&#10;%20 ä").getBytes(UTF_8));
    repository.commit("three");
    repository.run("validate-models", "x.lib").expect(0).says("nothing was checked");
  }

  private void assertCheckedWithAnyChange(byte[] model, String message) throws Exception {
    Files.write(repository.path("odd.xmi"), model);
    repository.commit(message);
    repository
        .run("validate-models", "x.lib")
        .expect(0)
        .says("1 of 4 models")
        .says("<validate><odd.xmi>");
  }

  @Test
  void whatKeepsItFromRunningIsNamed() throws Exception {
    Path outputs = Files.createFile(folder.resolve("outputs"));
    repository.set("GITHUB_OUTPUT", outputs.toString());
    repository.set("TMPDIR", folder.resolve("nowhere").toString());
    repository.run("validate-models").expect(2).says("no temporary file can be made in '");
    repository.unset("TMPDIR");
    repository.set("EVENTCHAIN", "no-such-program");
    repository.run("validate-models").expect(2).says("there is no program 'no-such-program'");
    repository.call("broken", "#!/no/such/shell\n");
    repository.run("validate-models").expect(2).says("could not be run");
    assertEquals("", Files.readString(outputs));
    repository.git("update-ref", "-d", "HEAD");
    repository.run("validate-models", "--since=main").expect(2).says("this branch has no commits");
  }

  @Test
  void exitCodesAreThoseOfTheProgram() throws Exception {
    for (int code = 0; code < 5; code++) {
      repository.write("code", Integer.toString(code));
      repository.run("validate-models", "a.xmi").expect(code);
    }
  }
}
