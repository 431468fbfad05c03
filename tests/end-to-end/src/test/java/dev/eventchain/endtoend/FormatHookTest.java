package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the hook of {@code bundles/front/ci} that formats files before a commit. */
class FormatHookTest {

  private static final String SCRIPT = "format-files";

  @TempDir Path folder;
  private ModelRepository repository;

  @BeforeEach
  void makeARepository() throws Exception {
    repository = ModelRepository.in(folder);
    repository.write("my car/eventchain.yaml", "name: car\n");
  }

  @Test
  void filesThatPeopleWriteAreFormatted() throws Exception {
    repository
        .run(SCRIPT, "--indent=4", "a.ocl", "my car/bench.yaml", "t/a.mtl", "a.xmi", "-b.ocl")
        .expect(2)
        .says("the option '-b.ocl' needs the form --name=value");
    repository
        .run(SCRIPT, "--check", "--indent=4", "a.ocl", "my car/bench.yaml", "t/a.mtl", "a.xmi")
        .expect(0)
        .says("<format><--check><--indent=4><a.ocl><my car/bench.yaml><t/a.mtl>");
    repository
        .run(SCRIPT, "--check", "t/../a.ocl", "../b.ocl")
        .expect(0)
        .says("<format><--check><t/../a.ocl><../b.ocl>");
    repository.write("code", "1");
    repository.run(SCRIPT, "a.ocl").expect(1);
  }

  /** YAML outside of projects may be anybody's, and what the program wrote is left as it is. */
  @Test
  void otherFilesAreLeftAlone() throws Exception {
    repository.write("code", "1");
    repository
        .run(
            SCRIPT,
            "docker.yaml",
            ".github/a.yml",
            "my car/.a.ocl",
            "my car/out/generated.ocl",
            "my car/recordings/a.yaml",
            "a.xmi")
        .expect(0)
        .says("there was nothing to format");
  }

  @Test
  void theRealProgramFormatsWhatTheHookNames() throws Exception {
    repository.call("real", new Program().script());
    repository.write("my car/bench.yaml", "inputs:\n    a: 1\n");
    repository.run(SCRIPT, "--check", "my car/bench.yaml").expect(1).says("[format.differs]");
    repository.run(SCRIPT, "my car/bench.yaml").expect(0).says("formatted my car/bench.yaml");
    assertEquals("inputs:\n  a: 1\n", Files.readString(repository.path("my car/bench.yaml")));
    repository.run(SCRIPT, "--check", "my car/bench.yaml").expect(0);
  }

  /** Build servers and pre-commit have a clone of this repository, with the program in its root. */
  @Test
  void theProgramOfTheOwnRepositoryIsCalled() throws Exception {
    Path scripts = Files.createDirectories(folder.resolve("clone/bundles/front/ci"));
    Files.move(folder.resolve("fake"), folder.resolve("clone/eventchain"));
    repository.unset("EVENTCHAIN");
    for (String name : List.of(SCRIPT, "validate-models")) {
      Files.copy(
          ModelRepository.SCRIPTS.resolve(name),
          scripts.resolve(name),
          StandardCopyOption.COPY_ATTRIBUTES);
    }
    repository.run(scripts.resolve(SCRIPT), "a.mtl").expect(0).says("<format><a.mtl>");
    repository.run(scripts.resolve("validate-models")).expect(0).says("<validate><a.xmi>");
  }

  @Test
  void theHookCallsTheScript() throws IOException {
    String hooks = Files.readString(Program.ROOT.resolve(".pre-commit-hooks.yaml"));
    String hook = hooks.substring(hooks.indexOf("- id: eventchain-format"));
    assertTrue(hook.contains("entry: bundles/front/ci/format-files\n"), hook);
    assertTrue(Files.isExecutable(ModelRepository.SCRIPTS.resolve(SCRIPT)));
    Pattern files = Pattern.compile(hook.replaceFirst("(?s).*\n  files: (.*?)\n.*", "$1"));
    for (String name : List.of("p/eventchain.yaml", "a.yml", "a/b.ocl", "c.mtl")) {
      assertTrue(files.matcher(name).find(), name);
    }
    for (String name : List.of("a.py", "a.ocl.orig", "yaml")) {
      assertFalse(files.matcher(name).find(), name);
    }
  }
}
