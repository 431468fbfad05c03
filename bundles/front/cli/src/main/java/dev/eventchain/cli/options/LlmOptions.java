package dev.eventchain.cli.options;

import dev.eventchain.pipeline.run.Answers;
import java.util.Optional;
import picocli.CommandLine.Option;

/** Options for the source of language models' answers. */
public final class LlmOptions {

  @Option(
      names = "--llm",
      paramLabel = "SOURCE",
      description =
          "Where answers come from: 'replay' takes the project's recordings; 'live' asks the"
              + " services of the models that eventchain.yaml names; 'SERVICE/MODEL' this model for"
              + " every task; 'auto' recordings first; 'command:PROGRAM' a program that gets the"
              + " prompt on standard input; 'handoff:FOLDER' writes each prompt that has no"
              + " recorded answer to a file, ends with exit code 4, and continues when called again"
              + " once the answer's file is there. Default: as eventchain.yaml says.")
  private String source;

  @Option(names = "--record", description = "Keep new answers as recordings of the project.")
  private boolean record;

  /** Returns the source that the command line names. */
  public Optional<String> source() {
    return Optional.ofNullable(source);
  }

  /** Returns the wanted answers. */
  public Answers answers() {
    return new Answers(source(), record);
  }
}
