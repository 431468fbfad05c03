package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * A git repository with a metamodel and three models, one of which refers to another, for the
 * scripts of {@code bundles/front/ci}. They call a program that prints its arguments.
 */
final class ModelRepository {

  static final Path SCRIPTS = Program.ROOT.resolve("bundles/front/ci");

  static final String METAMODEL =
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

  private final Path folder;
  private final Path repository;
  private final Map<String, String> environment = new TreeMap<>();

  private ModelRepository(Path folder) throws IOException {
    this.folder = folder;
    this.repository = Files.createDirectory(folder.resolve("a repository"));
  }

  /** Makes the repository in a folder, which is also for the program and its output. */
  static ModelRepository in(Path folder) throws Exception {
    ModelRepository made = new ModelRepository(folder);
    made.git("init", "-q", "-b", "main");
    made.write("shop.ecore", METAMODEL);
    made.write("a.xmi", shop("A", ""));
    made.write("with blanks/b 1.xmi", shop("B", ""));
    made.write("refers.xmi", shop("R", "<branch href=\"with%20blanks/b%201.xmi#/\"/>"));
    made.commit("one");
    made.call("fake", FAKE);
    return made;
  }

  /** Returns the path of a file. */
  Path path(String name) {
    return repository.resolve(name);
  }

  /** Sets an environment variable for the scripts. */
  void set(String name, String value) {
    environment.put(name, value);
  }

  void unset(String name) {
    environment.remove(name);
  }

  /** Lets the scripts call a program that is this text. */
  void call(String name, String text) throws IOException {
    Path file = Files.writeString(folder.resolve(name), text);
    assertTrue(file.toFile().setExecutable(true));
    set("EVENTCHAIN", file.toString());
  }

  /** Returns the text of a model. */
  static String shop(String name, String content) {
    return """
    <?xml version="1.0" encoding="UTF-8"?>
    <shop:Shop xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI"
        xmlns:shop="http://example.org/shop" name="%s">%s</shop:Shop>
    """
        .formatted(name, content);
  }

  /** Writes a file. */
  void write(String name, String text) throws IOException {
    Path file = repository.resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }

  /** Commits all files as they are. */
  void commit(String message) throws Exception {
    git("add", "-A");
    git("commit", "-q", "-m", message);
  }

  /** Calls git. */
  void git(String... arguments) throws Exception {
    List<String> command = new ArrayList<>(List.of("git"));
    for (String setting : List.of("user.name=a", "user.email=a@b", "commit.gpgsign=false")) {
      command.addAll(List.of("-c", setting));
    }
    Stream.of(arguments).forEach(command::add);
    ended(command, repository).expect(0);
  }

  /** Runs a script in the root folder. */
  Program.Ended run(String script, String... arguments) throws Exception {
    return runIn(repository, script, arguments);
  }

  /** Runs a script that is elsewhere, in the root folder. */
  Program.Ended run(Path script, String... arguments) throws Exception {
    List<String> command = new ArrayList<>(List.of(script.toString()));
    command.addAll(List.of(arguments));
    return ended(command, repository);
  }

  /** Runs {@code validate-models} in a folder. */
  Program.Ended runIn(String name, String... arguments) throws Exception {
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
