package dev.eventchain.llm;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.llm.service.ModelServices;
import java.nio.file.Path;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;

/**
 * How the language models of one run are reached.
 *
 * @param source how answers are got: {@code replay} takes them from the recordings, {@code live}
 *     asks the services, {@code auto} the services for what is not recorded, {@code handoff:FOLDER}
 *     a person through files in that folder for what is not recorded, {@code command:PROGRAM
 *     ARGUMENTS} a program; {@code SERVICE/MODEL} is {@code live} with that model for every task
 * @param recordings the folder of the recordings, {@code TASK/NAME-KEY.json} in the format {@code
 *     llm-recording/1}
 * @param record whether new answers are recorded
 * @param services where models are, and what they cost
 * @param spending what the run has spent
 * @param environment the value of an environment variable, null if it is not set
 * @param progress is told what a person may want to know while waiting, often
 * @param findings is told what is wrong with answers that there are
 */
public record ModelAccess(
    String source,
    Path recordings,
    boolean record,
    ModelServices services,
    Spending spending,
    UnaryOperator<String> environment,
    Consumer<String> progress,
    Consumer<Diagnostic> findings) {

  /** A run without services of its own, without a budget and without anybody who listens. */
  public static ModelAccess of(String source, Path recordings, boolean record) {
    ModelServices services = ModelServices.usual();
    return new ModelAccess(
        source,
        recordings,
        record,
        services,
        new Spending(services),
        System::getenv,
        message -> {},
        finding -> {});
  }
}
