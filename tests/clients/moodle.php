<?php
// Imports questions into a Moodle and answers them in its own question engine.
//
//   php moodle.php MOODLE QUESTIONS.xml ATTEMPTS.json
//
// MOODLE is the folder of an installed Moodle. ATTEMPTS is a list of {"question": name, "responses": [{field: text}, ...]};
// printed is {"version": ..., "questions": number, "marks": [[fraction of the question's mark, ...], ...]}. Everything that is
// imported is deleted again.

define('CLI_SCRIPT', true);
[, $folder, $file, $attempts] = $argv;
require $folder . '/config.php';
error_reporting(E_ERROR | E_PARSE);
ini_set('display_errors', '0');
$CFG->debug = 0;
$CFG->debugdisplay = 0;
require_once $CFG->libdir . '/questionlib.php';
require_once $CFG->dirroot . '/question/format.php';
require_once $CFG->dirroot . '/question/format/xml/format.php';
require_once $CFG->dirroot . '/question/engine/lib.php';

\core\session\manager::set_user(get_admin());
$course = get_site();
$context = context_course::instance($course->id);
$contexts = new \core_question\local\bank\question_edit_contexts($context);
$category = question_make_default_categories($contexts->all());

$format = new qformat_xml();
$format->setContexts($contexts->having_one_edit_tab_cap('import'));
$format->setCourse($course);
$format->setFilename($file);
$format->setRealfilename(basename($file));
$format->setCategory($category);
$format->setMatchgrades('error');
$format->setCatfromfile(true);
$format->setContextfromfile(false);
$format->setStoponerror(true);
$format->set_display_progress(false);
ob_start();
$imported = $format->importpreprocess() && $format->importprocess();
$said = trim(strip_tags(ob_get_clean()));
if (!$imported || $said !== '') {
    fwrite(STDERR, "Moodle did not import $file: $said\n");
    exit(1);
}
$ids = [];
foreach ($format->questionids as $id) {
    $ids[$DB->get_field('question', 'name', ['id' => $id])] = $id;
}

$marks = [];
foreach (json_decode(file_get_contents($attempts), true) as $each) {
    $question = question_bank::load_question($ids[$each['question']]);
    $given = [];
    foreach ($each['responses'] as $response) {
        $usage = question_engine::make_questions_usage_by_activity('core_question_preview', $context);
        $usage->set_preferred_behaviour('deferredfeedback');
        $slot = $usage->add_question($question, 1.0);
        $usage->start_question($slot, 1);
        $usage->process_action($slot, $response);
        $usage->finish_question($slot);
        $given[] = $usage->get_question_fraction($slot);
    }
    $marks[] = $given;
}
foreach ($ids as $id) {
    question_delete_question($id);
}
echo json_encode(['version' => $CFG->release, 'questions' => count($ids), 'marks' => $marks]);
