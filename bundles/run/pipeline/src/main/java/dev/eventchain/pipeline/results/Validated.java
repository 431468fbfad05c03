package dev.eventchain.pipeline.results;

/** The report of the stage that validates the model. */
public record Validated(Validation validation) implements StageReport {}
