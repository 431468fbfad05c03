package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileReads;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.bench.Bench;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileVisitOption;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;

/** A folder with scenarios, including its subfolders. */
record ScenarioFolder(Path folder) {

  /**
   * Returns all files but hidden ones, in the order of their paths. Links are followed; a dangling
   * link counts as a file, so that reading it fails.
   *
   * @throws DiagnosticException INPUT if the folder cannot be listed
   */
  List<Path> files() {
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    try (Stream<Path> all = Files.walk(folder, FileVisitOption.FOLLOW_LINKS)) {
      return all.filter(file -> !Files.isDirectory(file) && !isHidden(file))
          .sorted(Comparator.comparing(this::nameOf))
          .toList();
    } catch (IOException e) {
      throw FileRules.refusal("The folder", folder, e);
    } catch (UncheckedIOException e) {
      throw FileRules.refusal("The folder", folder, e.getCause());
    }
  }

  private String nameOf(Path file) {
    return folder.relativize(file).toString().replace('\\', '/');
  }

  private boolean isHidden(Path file) {
    for (Path part : folder.relativize(file)) {
      if (part.toString().startsWith(".")) {
        return true;
      }
    }
    return false;
  }

  /**
   * Returns all files, and those that they lead to: OpenSCENARIO files, and what these lead to. A
   * file that cannot be read is a finding later.
   */
  List<Path> allFiles() {
    return withPlayed(files());
  }

  /** Returns some files and then those to which the scenarios among them lead. */
  static List<Path> withPlayed(List<Path> files) {
    List<Path> all = new ArrayList<>(files);
    Set<Path> known = new HashSet<>();
    files.forEach(file -> known.add(file.toAbsolutePath().normalize()));
    played(files).stream().filter(file -> !known.contains(file)).forEach(all::add);
    return all;
  }

  /**
   * Returns the files to which the scenarios among some files lead, in the order of their paths.
   */
  private static Set<Path> played(List<Path> files) {
    Runnable reading =
        () ->
            files.stream()
                .filter(ScenarioFolder::isScenario)
                .forEach(
                    file -> {
                      try {
                        ScenarioReader.played(SourceText.read(file));
                      } catch (DiagnosticException e) {
                        // Reading the scenarios reports it.
                      }
                    });
    return FileReads.record(
            () -> {
              reading.run();
              return true;
            })
        .files();
  }

  private static boolean isScenario(Path file) {
    return file.getFileName().toString().toLowerCase(Locale.ROOT).matches(".*\\.ya?ml");
  }

  /** Reads the scenarios as {@link Scenario#readFolder} does. */
  List<Scenario> read(Bench bench, Consumer<Diagnostic> warnings) {
    List<Diagnostic> problems = new ArrayList<>();
    List<Diagnostic> warned = new ArrayList<>();
    List<Scenario> scenarios = new ArrayList<>();
    List<Path> files = files();
    Set<Path> read =
        FileReads.record(
                () -> {
                  files.stream()
                      .filter(ScenarioFolder::isScenario)
                      .forEach(file -> read(file, bench, scenarios, problems, warned));
                  return true;
                })
            .files();
    files.stream()
        .filter(file -> !isScenario(file) && !read.contains(file.toAbsolutePath().normalize()))
        .forEach(file -> warned.add(unread(file)));
    refuseDuplicates(scenarios, problems);
    if (scenarios.isEmpty() && problems.isEmpty()) {
      problems.add(none());
      problems.addAll(warned);
    }
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    warned.forEach(warnings);
    return List.copyOf(scenarios);
  }

  private static void read(
      Path file,
      Bench bench,
      List<Scenario> scenarios,
      List<Diagnostic> problems,
      List<Diagnostic> warnings) {
    try {
      scenarios.addAll(ScenarioReader.read(SourceText.read(file), bench, warnings::add));
    } catch (DiagnosticException e) {
      problems.addAll(e.diagnostics());
    }
  }

  private static Diagnostic unread(Path file) {
    boolean played = ScenarioFiles.isOpenScenario(file);
    return Diagnostic.of(
            ScenarioRules.FILE_UNREAD,
            played
                ? "This is not simulated: no scenario names it."
                : "This is not simulated: its name does not end in .yaml or .yml.",
            SourceLocation.of(file))
        .withHint(
            played
                ? "Write a scenario with `openscenario: {file: "
                    + file.getFileName()
                    + "}`, and with `accept`: what is required is not in such files."
                : "Rename a scenario; move anything else, or let its name begin with a dot.");
  }

  private Diagnostic none() {
    return Diagnostic.of(
            ScenarioRules.NONE, "There is no scenario to simulate.", SourceLocation.of(folder))
        .withHint("Put at least one scenario file (*.yaml) into this folder.");
  }

  static void refuseDuplicates(List<Scenario> scenarios, List<Diagnostic> problems) {
    Map<String, Scenario> byName = new HashMap<>();
    for (Scenario scenario : scenarios) {
      Scenario earlier = byName.putIfAbsent(scenario.name(), scenario);
      if (earlier != null) {
        String message = "The name " + scenario.name() + " is taken by " + earlier.location() + ".";
        problems.add(
            Diagnostic.of(ScenarioRules.NAME_DUPLICATE, message, scenario.location())
                .withHint("Give each scenario its own name; reports and measurements use it."));
      }
    }
  }
}
