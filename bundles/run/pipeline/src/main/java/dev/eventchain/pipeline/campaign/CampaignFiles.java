package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.project.Project;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The campaign files of a project, checked by themselves: nothing is generated or simulated. */
public final class CampaignFiles {

  private static final String FOLDER = "campaigns";

  /** A key that no campaign file does without. */
  private static final Pattern KEY =
      Pattern.compile("^(scenario|factors|campaigns)\\s*:", Pattern.MULTILINE);

  private CampaignFiles() {}

  /**
   * Returns what is wrong with the campaign files below {@code campaigns/} of a project, before
   * their scenarios are looked at: what {@code campaign} and {@code search} both report. A file of
   * another kind, without any of the keys of a campaign, is passed over.
   */
  public static List<Diagnostic> problems(Project project) {
    List<Diagnostic> found = new ArrayList<>();
    for (Path file : in(project.folder().resolve(FOLDER))) {
      if (isCampaign(file)) {
        found.addAll(problems(file));
      }
    }
    return found;
  }

  /** Returns whether a file has a key of a campaign; one that cannot be read is reported as one. */
  private static boolean isCampaign(Path file) {
    try {
      return KEY.matcher(SourceText.read(file).text()).find();
    } catch (DiagnosticException e) {
      return true;
    }
  }

  private static List<Path> in(Path folder) {
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    try (Stream<Path> files = Files.walk(folder)) {
      return files
          .filter(file -> file.toString().matches(".*\\.ya?ml"))
          .filter(Files::isRegularFile)
          .sorted()
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns what both readers report: a search goes between bounds that a grid cannot combine. */
  private static List<Diagnostic> problems(Path file) {
    List<Diagnostic> found = new ArrayList<>(problems(file, CampaignReader::read));
    found.retainAll(problems(file, CampaignReader::readForSearch));
    return found;
  }

  private static List<Diagnostic> problems(Path file, Consumer<Path> reader) {
    try {
      reader.accept(file);
      return List.of();
    } catch (DiagnosticException e) {
      return e.diagnostics();
    }
  }
}
