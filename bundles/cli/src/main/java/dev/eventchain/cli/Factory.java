package dev.eventchain.cli;

import java.io.PrintWriter;
import java.lang.reflect.Constructor;
import picocli.CommandLine;

/** Makes the commands, giving those that want it the console. */
final class Factory implements CommandLine.IFactory {

  private final Console console;

  Factory(PrintWriter out, PrintWriter err, Terminal terminal) {
    this.console = new Console(out, err, terminal);
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
