package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import dev.eventchain.pipeline.results.ResultJson;
import java.util.List;
import java.util.Locale;

/** The suites that come with the program, with their sources and numbers of cases. */
public record SuiteList(List<Suite> suites) {

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
  public SuiteList {
    suites = List.copyOf(suites);
  }

  /** Counts the cases of all suites, as a simulation would have them. */
  public static SuiteList known() {
    return new SuiteList(Suites.names().stream().map(SuiteList::suite).toList());
  }

  private static Suite suite(String name) {
    List<Part> parts = Suites.campaigns(name).stream().map(SuiteList::part).toList();
    int cases = parts.stream().mapToInt(Part::cases).sum();
    return new Suite(name, Suites.source(name), cases, parts);
  }

  private static Part part(CampaignPlan plan) {
    return new Part(plan.part().orElseThrow(), plan.scenario(), new CaseList(plan).cases().size());
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
