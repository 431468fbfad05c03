package dev.eventchain.simulation.bench;

/** A topic and its message type. */
public record TypedTopic(String name, String type) {}
