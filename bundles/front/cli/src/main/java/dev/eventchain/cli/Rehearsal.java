package dev.eventchain.cli;

import dev.eventchain.cli.console.Terminal;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;

/**
 * Runs the most common commands without output. The launcher runs it once per JDK with the JVM
 * option that archives the loaded classes at the end.
 */
final class Rehearsal {

  private static final String CLASS = ".class";

  private Rehearsal() {}

  /**
   * Runs the commands and ends the process in the ordinary way: a halt may skip what the JVM does
   * at the end.
   *
   * @param arguments the project's root folder, and an empty folder to write into
   */
  public static void main(String[] arguments) throws IOException {
    Path root = Path.of(arguments[0]);
    Path scratch = Path.of(arguments[1]);
    commands(root, scratch).forEach(Rehearsal::run);
    for (String jar : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
      if (Path.of(jar).getFileName().toString().startsWith("eventchain-")) {
        loadAll(jar);
      }
    }
    System.exit(0);
  }

  private static List<List<String>> commands(Path root, Path scratch) {
    String example = root.resolve("examples/aeb").toString();
    Path results = scratch.resolve(ProjectLayout.OUTPUT);
    String out = results.toString();
    String model = results.resolve(ProjectFolder.MODEL).toString();
    String ecore = root.resolve("metamodel/eventchain.ecore").toString();
    String ocl = root.resolve("metamodel/eventchain.ocl").toString();
    String template = root.resolve("templates/ros2-python/main.mtl").toString();
    String generated = scratch.resolve("generated").toString();
    return List.of(
        List.of("design", example, "-o", out),
        List.of("model", example, "-o", out),
        List.of("constrain", example, "-o", out),
        List.of("validate", example, "-o", out),
        List.of("validate", "--metamodel", ecore, "--ocl", ocl, model),
        List.of("generate", "--metamodel", ecore, "--template", template, model, "-o", generated),
        List.of("validate", "--metamodel", ecore, "--ocl", ocl, ocl),
        List.of("--help"));
  }

  /** Runs a command and ignores its exit code: it only has to load its classes. */
  private static void run(List<String> command) {
    PrintWriter nowhere = new PrintWriter(Writer.nullWriter());
    Main.run(command.toArray(new String[0]), nowhere, nowhere, Terminal.of(System.getenv()));
  }

  /** Loads the classes of stages that are not run above because they would start other programs. */
  private static void loadAll(String jar) throws IOException {
    try (JarFile file = new JarFile(jar)) {
      for (JarEntry entry : file.stream().toList()) {
        String name = entry.getName();
        if (name.endsWith(CLASS) && name.startsWith("dev/")) {
          load(name.substring(0, name.length() - CLASS.length()).replace('/', '.'));
        }
      }
    }
  }

  private static void load(String name) {
    try {
      Class.forName(name, false, Rehearsal.class.getClassLoader());
    } catch (ClassNotFoundException | LinkageError e) {
      // A class with missing dependencies is not needed here either.
    }
  }
}
