package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.output.OutputRules;
import dev.eventchain.pipeline.campaign.result.CampaignStore;
import dev.eventchain.pipeline.files.SourceFile;
import dev.eventchain.simulation.scenario.Scenario;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/** The finds of a search as scenarios of the project. */
final class FoundScenarios {

  /** The folder among the results, and among the scenarios of a project. */
  static final String FOLDER = "found";

  private final CampaignScene scene;
  private final List<SearchFinds.Find> finds;

  FoundScenarios(CampaignScene scene, List<SearchFinds.Find> finds) {
    this.scene = scene;
    this.finds = List.copyOf(finds);
  }

  /** Returns the name of a scenario. */
  String name(int number) {
    return scene.scenario().name() + "-found-" + number;
  }

  /** Returns the name of a scenario's file. */
  String file(int number) {
    return FOLDER + "/" + name(number) + ".yaml";
  }

  private String text(SearchFinds.Find find, int number, Path folder) {
    String words = find.simple().id().words(scene.plan());
    String title = scene.scenario().title() + ": " + words;
    return String.format(
            Locale.ROOT,
            """
        # Found by a search (%s, run %d of %d), and made simpler: %s
        # %s
        """,
            scene.plan().file().getFileName(),
            find.run() + 1,
            scene.plan().search().runs(),
            words,
            find.simple().result().reason().replaceAll("\\s+", " "))
        + scene.template().text(find.simple().id(), folder, name(number), title);
  }

  /** Writes a file for each find, and its bench if it is not the project's. */
  void write(CampaignStore store) {
    for (int i = 0; i < finds.size(); i++) {
      String found = text(finds.get(i), i + 1, store.path(FOLDER));
      store.write(file(i + 1), found.getBytes(StandardCharsets.UTF_8));
      String bench = FOLDER + "/" + name(i + 1) + ".bench.txt";
      scene
          .template()
          .bench(finds.get(i).simple().id())
          .ifPresent(text -> store.write(bench, text.getBytes(StandardCharsets.UTF_8)));
    }
  }

  /**
   * Writes the finds into the folder of the project's scenarios, under the first numbers that are
   * free, unless they are there. Returns what became of each, in words.
   */
  String keep() {
    StringBuilder words = new StringBuilder();
    for (int i = 0; i < finds.size(); i++) {
      SearchFinds.Find find = finds.get(i);
      if (scene.template().bench(find.simple().id()).isPresent()) {
        words.append("Not kept: ").append(name(i + 1)).append(" needs another bench.yaml\n");
      } else {
        words.append("Kept: ").append(keep(find)).append('\n');
      }
    }
    return words.toString();
  }

  private Path keep(SearchFinds.Find find) {
    Path scenarios = scene.run().project().scenarios();
    for (int number = 1; ; number++) {
      Path target = scenarios.resolve(file(number));
      String text = text(find, number, target.getParent());
      if (Files.exists(target) && isSame(target, text)) {
        return target;
      }
      if (!Files.exists(target) && isFree(name(number))) {
        write(target, text);
        return target;
      }
    }
  }

  private boolean isFree(String name) {
    return scene.scenarios().stream().map(Scenario::name).noneMatch(name::equals);
  }

  /** Returns whether a file has this text, but for comments, which say how it was found. */
  private static boolean isSame(Path file, String text) {
    return withoutComments(SourceText.read(file).text()).equals(withoutComments(text));
  }

  private static List<String> withoutComments(String text) {
    return text.lines().filter(line -> !line.startsWith("#")).toList();
  }

  private static void write(Path file, String text) {
    Path folder = file.getParent();
    if (Files.isSymbolicLink(folder)) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
                  OutputRules.OUTPUT_PATH_REFUSED,
                  "'" + FOLDER + "' is a link that leads elsewhere.",
                  SourceLocation.of(folder))
              .withHint("Replace it with a folder: nothing is written outside the project."));
    }
    try {
      Files.createDirectories(folder);
    } catch (IOException e) {
      throw SourceFile.unwritable(folder, e);
    }
    SourceFile.write(file, text);
  }
}
