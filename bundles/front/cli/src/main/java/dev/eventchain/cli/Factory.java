package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import java.lang.reflect.Constructor;
import picocli.CommandLine;

/** Creates the commands and passes the console to those that need it. */
final class Factory implements CommandLine.IFactory {

  private final Console console;

  Factory(Console console) {
    this.console = console;
  }

  @Override
  public <K> K create(Class<K> type) throws Exception {
    for (Constructor<?> constructor : type.getDeclaredConstructors()) {
      if (constructor.getParameterCount() == 1
          && constructor.getParameterTypes()[0] == Console.class) {
        return type.cast(constructor.newInstance(console));
      }
    }
    return CommandLine.defaultFactory().create(type);
  }
}
