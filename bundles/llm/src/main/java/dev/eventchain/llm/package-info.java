/** Language models behind a narrow interface: providers, recordings and hand-off. */
package dev.eventchain.llm;
