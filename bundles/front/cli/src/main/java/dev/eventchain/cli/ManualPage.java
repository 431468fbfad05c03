package dev.eventchain.cli;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.Help;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/** A manual page (section 1, roff with the macros of man(7)) of the program or of one command. */
final class ManualPage {

  private final CommandLine command;
  private final Help help;
  private final CommandSpec specification;
  private final StringBuilder roff = new StringBuilder();

  ManualPage(CommandLine command) {
    this.command = command;
    this.help = command.getHelp();
    this.specification = command.getCommandSpec();
  }

  /** Returns the name as for man(1), such as {@code eventchain-run}. */
  String name() {
    return specification.qualifiedName("-");
  }

  /** Returns the page. It states no date, so that the same program has the same pages. */
  String text() {
    roff.setLength(0);
    roff.append(".TH ").append(name().toUpperCase(Locale.ROOT)).append(" 1 \"\" \"eventchain ");
    roff.append(escaped(Main.version())).append("\" \"Eventchain\"\n");
    UsageMessageSpec usage = specification.usageMessage();
    section("NAME");
    line(name() + " - " + summary(specification));
    section("SYNOPSIS");
    synopsis(usage);
    section("DESCRIPTION");
    paragraph(usage.description());
    entries("ARGUMENTS", specification.positionalParameters());
    entries("OPTIONS", specification.options());
    commands();
    environment();
    if (usage.footer().length > 0) {
      section("NOTES");
      paragraph(usage.footer());
    }
    seeAlso();
    return roff.toString();
  }

  /** Returns the first sentence of a description, without its end. */
  private static String summary(CommandSpec specification) {
    String all = String.join(" ", specification.usageMessage().description());
    return all.replaceFirst("(?s)\\.(\\s.*|$)", "");
  }

  private void synopsis(UsageMessageSpec usage) {
    String[] written = usage.customSynopsis();
    List<String> lines = written.length > 0 ? List.of(written) : help.synopsis(0).lines().toList();
    roff.append(".nf\n");
    lines.forEach(line -> roff.append("\\&").append(escaped(line.stripTrailing())).append('\n'));
    roff.append(".fi\n");
  }

  private void entries(String title, List<? extends ArgSpec> all) {
    List<? extends ArgSpec> shown = all.stream().filter(entry -> !entry.hidden()).toList();
    if (shown.isEmpty()) {
      return;
    }
    section(title);
    for (ArgSpec entry : shown) {
      String label =
          help.parameterLabelRenderer()
              .renderParameterLabel(entry, Help.Ansi.OFF, List.of())
              .toString();
      String names =
          entry instanceof OptionSpec option ? String.join(", ", option.names()) + label : label;
      entry(names.strip(), entry.description());
    }
  }

  private void entry(String name, String... description) {
    roff.append(".TP\n.B ").append(escaped(name)).append('\n');
    paragraph(description);
  }

  private void commands() {
    if (command.getSubcommands().isEmpty()) {
      return;
    }
    section("COMMANDS");
    for (CommandLine each : command.getSubcommands().values()) {
      entry(each.getCommandName(), summary(each.getCommandSpec()) + ".");
    }
  }

  private void environment() {
    if (command.getParent() != null) {
      return;
    }
    section("ENVIRONMENT");
    entry("EVENTCHAIN_MEMORY", "How much memory the program may use, such as 4g (1g).");
    entry("EVENTCHAIN_PYTHON", "The Python to use instead of the first on the path.");
    entry(
        "EVENTCHAIN_WHEELS",
        "A folder of Python wheels. The Python packages that runs need come only from "
            + "there; without it, pip fetches them from its index at the first use.");
    entry(
        "EVENTCHAIN_CONFINEMENT", "bubblewrap, audit-hooks, or auto: the stronger one that works.");
    entry("XDG_CACHE_HOME", "Where the Python packages are kept (~/.cache).");
    entry("JAVA_HOME", "The Java that runs the program, version 17 or later.");
  }

  private void seeAlso() {
    Stream<CommandLine> others =
        command.getParent() == null
            ? command.getSubcommands().values().stream()
            : Stream.of(command.getParent());
    section("SEE ALSO");
    line(
        others
            .map(each -> each.getCommandSpec().qualifiedName("-") + "(1)")
            .collect(Collectors.joining(", ")));
  }

  private void section(String title) {
    roff.append(".SH ").append(title).append('\n');
  }

  /** Adds a paragraph, which begins with an empty line. */
  private void paragraph(String... lines) {
    for (String line : String.join("\n", lines).replace("%n", "\n").split("\n", -1)) {
      if (line.isBlank()) {
        roff.append(".sp\n");
      } else {
        line(line.replace("%%", "%"));
      }
    }
  }

  private void line(String text) {
    String escaped = escaped(text.strip());
    boolean isRequest = escaped.startsWith(".") || escaped.startsWith("'");
    roff.append(isRequest ? "\\&" : "").append(escaped).append('\n');
  }

  private static String escaped(String text) {
    return text.replace("\\", "\\e").replace("-", "\\-");
  }
}
