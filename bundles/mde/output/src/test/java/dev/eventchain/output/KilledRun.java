package dev.eventchain.output;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/** Run in its own process that changes a file and then waits to be killed. */
final class KilledRun {

  private KilledRun() {}

  static Process start(Path base) throws IOException {
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                KilledRun.class.getName(),
                base.toString())
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    BufferedReader output =
        new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    if (!"ready".equals(output.readLine())) {
      throw new IOException("the other run did not start");
    }
    return process;
  }

  @SuppressWarnings("resource") // left open on purpose
  public static void main(String[] arguments) throws IOException {
    OutputFolder folder = OutputFolder.open(Path.of(arguments[0]));
    folder.write("whole", "killed".getBytes(StandardCharsets.UTF_8));
    System.out.println("ready");
    // Waits until it is killed, or until the parent process ends.
    while (System.in.read() >= 0) {}
  }
}
