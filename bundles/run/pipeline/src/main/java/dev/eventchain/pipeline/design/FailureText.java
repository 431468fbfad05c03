package dev.eventchain.pipeline.design;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.pipeline.stage.ComponentFiles;
import dev.eventchain.pipeline.stage.RunContext;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** The code and the tests of components that may be wrong, as text for a language model. */
final class FailureText {
  private final RunContext run;

  FailureText(RunContext run) {
    this.run = run;
  }

  /** Returns the code and the tests of components, each in a fenced block. */
  String code(List<String> components) {
    StringBuilder text = new StringBuilder();
    for (String name : components) {
      text.append("`").append(name).append("`:\n\n```python\n");
      text.append(SourceText.read(run.file(ComponentFiles.name(name))).text().strip());
      text.append("\n```\n\n");
      Path tests = TestFiles.place(run, name);
      if (Files.isRegularFile(tests)) {
        text.append("Its tests:\n\n```yaml\n").append(SourceText.read(tests).text().strip());
        text.append("\n```\n\n");
      }
    }
    return text.isEmpty() ? "All of these components are given.\n\n" : text.toString();
  }
}
