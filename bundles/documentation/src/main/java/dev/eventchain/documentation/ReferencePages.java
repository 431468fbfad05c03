package dev.eventchain.documentation;

import dev.eventchain.cli.Main;
import dev.eventchain.diagnostics.RulePage;
import dev.eventchain.pipeline.StandardRule;
import java.util.Map;
import java.util.TreeMap;
import picocli.CommandLine;
import picocli.CommandLine.Help.Ansi;

/** Reference pages, generated from the program's own help and rules. */
final class ReferencePages {

  private ReferencePages() {}

  /** Returns the help of all commands. */
  static String commands() {
    CommandLine program = Main.commandLine();
    StringBuilder text =
        new StringBuilder("# Commands\n\nWhat `eventchain COMMAND --help` prints.\n");
    text.append(help("eventchain", program));
    program.getSubcommands().forEach((name, command) -> text.append(help(name, command)));
    return text.toString();
  }

  private static String help(String title, CommandLine command) {
    String usage = command.getUsageMessage(Ansi.OFF).replace("```", "` ` `");
    return "\n## " + title + "\n\n```text\n" + usage + "```\n";
  }

  /** Returns the list of all findings. */
  static String rules() {
    StringBuilder text = new StringBuilder("# Findings\n\n");
    text.append("Each finding has an id, which stands behind it in brackets. ");
    text.append("`eventchain explain ID` prints the page of one.\n");
    String bundle = "";
    for (RulePage page : RulePage.all()) {
      if (!page.bundle().equals(bundle)) {
        bundle = page.bundle();
        text.append("\n## ").append(bundle).append("\n\n| id | |\n|---|---|\n");
      }
      text.append("| [").append(page.id()).append("](rules/").append(page.id());
      text.append(".md) | ").append(cell(page.firstSentence())).append(" |\n");
    }
    text.append(
        "\n## Standard constraints\n\nThese hold for every event chain.\n\n| name | |\n|---|---|\n");
    for (String name : StandardRule.names()) {
      text.append("| [")
          .append(name)
          .append("](rules/")
          .append(fileName(name))
          .append(".md) | |\n");
    }
    return text.toString();
  }

  /** Returns text for a table cell, without links, which would be relative to another folder. */
  private static String cell(String text) {
    return text.replaceAll("\\[([^\\]]*)\\]\\([^)]*\\)", "$1").replace("|", "\\|");
  }

  /** Returns a page for each finding and each standard constraint, by the name of its file. */
  static Map<String, String> ofEachRule() {
    Map<String, String> pages = new TreeMap<>();
    RulePage.all().forEach(page -> pages.put("rules/" + page.id(), page.text()));
    for (String name : StandardRule.names()) {
      pages.put("rules/" + fileName(name), StandardRule.page(name).orElseThrow());
    }
    return pages;
  }

  private static String fileName(String constraint) {
    return constraint.replace("::", "-");
  }
}
