package dev.eventchain.documentation;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.cli.Main;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/** Tests the texts of the commands' help, which picocli formats: a lone % would be a warning. */
class CommandHelpTest {

  private static void addTexts(CommandLine command, List<String> texts) {
    UsageMessageSpec usage = command.getCommandSpec().usageMessage();
    texts.addAll(List.of(usage.header()));
    texts.addAll(List.of(usage.description()));
    texts.addAll(List.of(usage.footer()));
    for (ArgSpec argument : command.getCommandSpec().args()) {
      texts.addAll(List.of(argument.description()));
    }
    command.getSubcommands().values().forEach(each -> addTexts(each, texts));
  }

  @Test
  void eachTextCanBeFormatted() {
    List<String> texts = new ArrayList<>();
    addTexts(Main.commandLine(), texts);
    assertTrue(texts.stream().anyMatch(it -> it.contains("%%")), "the texts of commands");
    for (String text : texts) {
      String own = text.replaceAll("\\$\\{[A-Z-]+}", "");
      assertDoesNotThrow(() -> String.format(Locale.ROOT, own), text);
    }
  }
}
