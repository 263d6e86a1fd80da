// Answers parts of an exam that runs in this page of Numbas, and gives the scores. `attempts` is a list of {question: name, part: place,
// answers: [texts of the fields, or the place of an option (null for none), ...]}; returned is a list of [{score, messages}, ...].
async (attempts) => {
  const exam = document.querySelector("numbas-exam").exam;
  await exam.signals.on("ready");
  const byName = Object.fromEntries(exam.questionList.map((each) => [each.name, each]));
  const chosen = (part, place) => part.stagedAnswer.map((row, at) => row.map(() => at === place));
  return attempts.map(({ question, part: place, answers }) => {
    const part = byName[question].parts[place];
    return answers.map((answer) => {
      part.storeAnswer(Array.isArray(answer) ? answer : chosen(part, answer));
      part.submit();
      return { score: part.answered ? part.score : 0, marks: part.marks, messages: part.markingFeedback.map((each) => each.message) };
    });
  });
}
