package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.ResourceText;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import dev.eventchain.pipeline.results.ResultJson;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/**
 * Suites: campaigns about scenarios of their own, which ask of any project what a protocol asks of
 * a function. Some come with the program.
 */
public final class Suites {

  /** The folder of those that come with the program, in the output folder. */
  private static final String FOLDER = "suites";

  private static final String RESOURCES = "/dev/eventchain/pipeline/suites/";

  /**
   * A suite that comes with the program.
   *
   * @param source the protocol that it is after
   * @param scenarios the names of its scenario files, and those of the files that they play
   */
  private record Known(String source, List<String> scenarios) {

    Known(String source, String... scenarios) {
      this(source, List.of(scenarios));
    }
  }

  /** The suites by their names, which are also those of their campaign files. */
  private static final Map<String, Known> KNOWN =
      new TreeMap<>(
          Map.of(
              "euro-ncap-2023-c2c",
              new Known(
                  "Euro NCAP, Test Protocol AEB Car-to-Car systems 4.3.1 (2023): CCRs, CCRm, CCRb",
                  "ccrb",
                  "ccrm",
                  "ccrs",
                  "next-lane"),
              "euro-ncap-2023-vru",
              new Known(
                  "Euro NCAP, Test Protocol AEB/LSS VRU systems 4.5.1 (2023): CPNA, CPFA, CPLA, CBNA, CBFA, CBLA",
                  "along-bicycle",
                  "along-pedestrian",
                  "beside-bicycle",
                  "beside-pedestrian",
                  "crossing-bicycle",
                  "crossing-bicycle.xosc",
                  "crossing-pedestrian"),
              "euro-ncap-2026-ccr",
              new Known(
                  "Euro NCAP, Crash Avoidance - Frontal Collisions (2026): CCRs, CCRm, CCRb",
                  "ccr",
                  "ccrb",
                  "next-lane"),
              "euro-ncap-2026-junction",
              new Known(
                  "Euro NCAP, Crash Avoidance - Frontal Collisions (2026): CCFtap, CCCscp",
                  "cccscp",
                  "ccftap",
                  "crossed-before",
                  "crossing.xosc",
                  "left-turn.xosc",
                  "turns-in-a-gap"),
              "un-r152",
              new Known(
                  "UN Regulation No. 152 (M1): car to car",
                  "bend-ahead",
                  "between-two-cars",
                  "cut-out",
                  "moving-target",
                  "oncoming",
                  "overhead-sign",
                  "stationary-target",
                  "steel-plate"),
              "un-r152-pedestrian",
              new Known(
                  "UN Regulation No. 152 (M1) with Supplement 1: car to pedestrian",
                  "beside",
                  "crossing"),
              "un-r157-alks",
              new Known(
                  "UN Regulation No. 157 (ALKS, 2021, up to 60 km/h): avoiding collisions",
                  "cut-in",
                  "cut-out",
                  "deceleration",
                  "next-lane",
                  "pedestrian")));

  /** The suites that come with the program, with their sources and numbers of cases. */
  public record Listing(List<Suite> suites) {

    /**
     * A suite.
     *
     * @param source the protocol that it is after
     * @param cases the cases of all its campaigns
     */
    public record Suite(String name, String source, int cases, List<Part> campaigns) {}

    /**
     * A campaign of a suite.
     *
     * @param scenario the file of its scenario, beside that of the suite
     */
    public record Part(String name, String scenario, int cases) {}

    /** Copies the list. */
    public Listing {
      suites = List.copyOf(suites);
    }

    private static Suite suite(String name) {
      List<Part> parts = campaigns(name).stream().map(Listing::part).toList();
      int cases = parts.stream().mapToInt(Part::cases).sum();
      return new Suite(name, KNOWN.get(name).source(), cases, parts);
    }

    private static Part part(CampaignPlan plan) {
      return new Part(
          plan.part().orElseThrow(), plan.scenario(), new CaseList(plan).cases().size());
    }

    /** Returns the list for people. */
    public String text() {
      int width =
          suites.stream()
              .flatMap(suite -> suite.campaigns().stream().map(part -> part.name().length() + 2))
              .reduce(0, Math::max);
      width = Math.max(width, suites.stream().mapToInt(it -> it.name().length()).max().orElse(0));
      StringBuilder text = new StringBuilder();
      for (Suite suite : suites) {
        text.append(line(suite.name(), width, suite.cases()) + "  " + suite.source() + "\n");
        for (Part part : suite.campaigns()) {
          text.append(line("  " + part.name(), width, part.cases())).append('\n');
        }
      }
      return text.toString();
    }

    private static String line(String name, int width, int cases) {
      return String.format(
          Locale.ROOT, "%-" + width + "s  %9s", name, Coverage.counted(cases, "case"));
    }

    /** Returns the list as JSON. */
    public String json() {
      return JsonLayout.of(ResultJson.tree(this)) + "\n";
    }
  }

  private Suites() {}

  /** Returns the names of those that come with the program. */
  public static List<String> names() {
    return List.copyOf(KNOWN.keySet());
  }

  /** Counts the cases of all suites, as a simulation would have them. */
  public static Listing list() {
    return new Listing(names().stream().map(Listing::suite).toList());
  }

  /** Returns the campaigns of a suite that comes with the program. */
  private static List<CampaignPlan> campaigns(String suite) {
    String file = suite + ".yaml";
    String text = ResourceText.of(Suites.class, RESOURCES + suite + "/" + file);
    return CampaignReader.read(Path.of(file), SourceText.of(file, text));
  }

  /**
   * Returns the campaign file of a suite.
   *
   * @param suite its name, or the path of its file
   * @param output the folder of results, into which the files of a name are written
   * @throws DiagnosticException (INPUT) if there is neither
   */
  public static Path file(String suite, Path output) {
    if (!KNOWN.containsKey(suite)) {
      Path file = Path.of(suite);
      if (Files.exists(file)) {
        return file;
      }
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
                  CampaignRules.NAME,
                  "There is no suite '" + suite + "', and no file of this name.",
                  SourceLocation.NONE)
              .withHint(
                  NearestName.of(suite, names())
                      .map(name -> "Did you mean '" + name + "'?")
                      .orElse("Known suites: " + String.join(", ", names()) + ".")));
    }
    Path folder = output.resolve(FOLDER).resolve(suite);
    try (OutputFolder written = OutputFolder.open(folder)) {
      write(written, suite, suite);
      KNOWN.get(suite).scenarios().forEach(scenario -> write(written, suite, scenario));
    }
    return folder.resolve(suite + ".yaml");
  }

  private static void write(OutputFolder written, String suite, String name) {
    String file = name.endsWith(".xosc") ? name : name + ".yaml";
    try (InputStream input = Suites.class.getResourceAsStream(RESOURCES + suite + "/" + file)) {
      written
          .write(file, input.readAllBytes(), OutputFolder.OnEdit.OVERWRITE)
          .finding()
          .filter(finding -> Diagnostic.anyError(List.of(finding)))
          .ifPresent(
              finding -> {
                throw new DiagnosticException(DiagnosticException.Reason.INPUT, List.of(finding));
              });
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
