package dev.eventchain.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import picocli.AutoComplete;
import picocli.CommandLine;

/**
 * Writes the manual pages and the bash completion from the commands. The build of the distribution
 * runs it.
 */
final class Manual {

  /** Columns of an 80-column terminal that a synopsis may use: man(1) indents it. */
  private static final int WIDTH = 72;

  private Manual() {}

  /**
   * Writes {@code man/man1/*.1}, a page for the program and one for each command, and {@code
   * completion/eventchain.bash}.
   *
   * @param arguments the folder to write into
   */
  public static void main(String[] arguments) throws IOException {
    Path folder = Path.of(arguments[0]);
    CommandLine program = Main.commandLine();
    program.setUsageHelpWidth(WIDTH);
    program.setColorScheme(CommandLine.Help.defaultColorScheme(CommandLine.Help.Ansi.OFF));
    Path pages = Files.createDirectories(folder.resolve("man/man1"));
    write(pages, new ManualPage(program));
    for (CommandLine command : program.getSubcommands().values()) {
      write(pages, new ManualPage(command));
    }
    Path completion = Files.createDirectories(folder.resolve("completion"));
    Files.writeString(
        completion.resolve("eventchain.bash"), AutoComplete.bash("eventchain", program));
  }

  private static void write(Path folder, ManualPage page) throws IOException {
    Files.writeString(folder.resolve(page.name() + ".1"), page.text());
  }
}
