package dev.eventchain.pipeline.campaign;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.Pattern;

/** The campaign files of a project, checked by themselves: nothing is generated or simulated. */
public final class CampaignFiles {

  private static final String FOLDER = "campaigns";

  private static final String CAMPAIGNS = "campaigns";

  /** Keys of which no campaign is without all. */
  private static final Set<String> KEYS = Set.of("scenario", "factors", CAMPAIGNS);

  /** One of the keys at the left margin of a text that is no YAML, or not yet. */
  private static final Pattern KEY =
      Pattern.compile("^(['\"]?)(scenario|factors|campaigns)\\1\\s*:", Pattern.MULTILINE);

  private CampaignFiles() {}

  /**
   * Returns what is wrong with the campaign files below {@code campaigns/} of a project: what
   * {@code campaign} and {@code search} both report. If the project has a chain, its scenarios, and
   * can be read, that includes paths and values of factors that do not fit the scenario or the
   * bench. A file of another kind is passed over, and a folder that cannot be read is reported.
   *
   * @param project the folder of the project
   */
  public static List<Diagnostic> problems(Path project) {
    Path folder = project.resolve(FOLDER);
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    List<Diagnostic> found = new ArrayList<>();
    List<Path> files = in(folder, found).stream().filter(CampaignFiles::isCampaign).toList();
    Optional<CampaignWorld> world = files.isEmpty() ? Optional.empty() : CampaignWorld.of(project);
    files.forEach(
        file ->
            found.addAll(
                problemsOf(file, plans -> world.map(it -> it.check(plans)).orElse(List.of()))));
    return found;
  }

  /** Returns whether a file is of a campaign; one that cannot be read is reported as one. */
  private static boolean isCampaign(Path file) {
    try {
      return isCampaign(SourceText.read(file).text());
    } catch (DiagnosticException e) {
      return true;
    }
  }

  /**
   * Returns whether a text in YAML is one of campaigns, by the keys of its outermost object: it has
   * one that no other file has, or misspells all that a campaign needs.
   */
  public static boolean isCampaign(String text) {
    try {
      return Document.parseIfAny(
              SourceText.of("", text),
              DocumentFormat.YAML,
              CampaignRules.OF_DOCUMENTS,
              problem -> {})
          .map(Document::root)
          .filter(CampaignFiles::isCampaign)
          .isPresent();
    } catch (DiagnosticException e) {
      return KEY.matcher(text).find();
    }
  }

  private static boolean isCampaign(JsonNode root) {
    Set<String> meant = new HashSet<>();
    for (String key : (Iterable<String>) root::fieldNames) {
      if (KEYS.contains(key)) {
        return true;
      }
      NearestName.of(key, KEYS)
          .filter(near -> !near.equals(CAMPAIGNS) || root.get(key).isObject())
          .ifPresent(meant::add);
    }
    return meant.contains(CAMPAIGNS) || meant.size() > 1;
  }

  private static Set<Path> in(Path folder, List<Diagnostic> unreadable) {
    Set<Path> files = new TreeSet<>();
    SimpleFileVisitor<Path> visitor =
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
            if (file.toString().matches(".*\\.ya?ml") && Files.isRegularFile(file)) {
              files.add(file);
            }
            return FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFileFailed(Path file, IOException e) {
            unreadable.add(FileRules.unreadable("The file or folder", file, e));
            return FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult postVisitDirectory(Path visited, IOException e) {
            return e == null ? FileVisitResult.CONTINUE : visitFileFailed(visited, e);
          }
        };
    try {
      Files.walkFileTree(folder, visitor);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return files;
  }

  /**
   * Returns what both readers report: a search goes between bounds that a grid cannot combine. If
   * each refuses the file for a reason of its own, these are those of {@code campaign}.
   */
  private static List<Diagnostic> problemsOf(
      Path file, Function<List<CampaignPlan>, List<Diagnostic>> check) {
    List<Diagnostic> found = problems(file, CampaignReader::read, check);
    List<Diagnostic> ofSearch = problems(file, CampaignReader::readForSearch, check);
    List<Diagnostic> both = new ArrayList<>(found);
    both.retainAll(ofSearch);
    return both.isEmpty() && !ofSearch.isEmpty() ? found : both;
  }

  private static List<Diagnostic> problems(
      Path file,
      Function<Path, List<CampaignPlan>> reader,
      Function<List<CampaignPlan>, List<Diagnostic>> check) {
    try {
      return check.apply(reader.apply(file));
    } catch (DiagnosticException e) {
      return e.diagnostics();
    }
  }
}
