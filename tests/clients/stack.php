<?php
// Answers STACK questions in STACK's own question type and potential response trees, with Maxima.
//
//   php stack.php STACK DATA QUESTIONS.xml ATTEMPTS.json
//
// STACK is a checkout of maths/moodle-qtype_stack, whose api folder stands for Moodle; DATA an empty folder for its Maxima
// files. ATTEMPTS is a list of {"question": name, "responses": [{input: text, ...}, ...]}; printed is {"version": ..., "marks":
// [[{"score": number or null, "feedback": html}, ...], ...]}. Null is an answer that STACK cannot mark.

error_reporting(E_ERROR | E_PARSE);
[, $folder, $data, $file, $attempts] = $argv;
spl_autoload_register(function ($class) {
    if (str_starts_with($class, 'Symfony\\Component\\Yaml\\')) {
        require_once '/usr/share/php/' . str_replace('\\', '/', $class) . '.php';
    }
});
$sample = file_get_contents("$folder/api/config_sample.txt");
file_put_contents("$folder/config.php", str_replace('$CFG->dataroot = "/var/data/api";', '$CFG->dataroot = "' . $data . '";', $sample));
chdir("$folder/api");
require_once "$folder/config.php";
$CFG->dirroot = "$data/moodle"; // in which Maxima looks for STACK's libraries
@mkdir("$data/moodle/question/type", 0700, true);
@symlink(realpath($folder), "$data/moodle/question/type/stack");
$CFG->libdir = "$folder/api/emulation/libdir";
$CFG->platform = 'linux';
$CFG->maximaversion = 'default';
$CFG->maximacommand = 'maxima';
$CFG->maximacommandopt = '';
$CFG->maximalocalfolder = "$data/stack/";
$CFG->castimeout = 60;
$CFG->casdebugging = 0;
require_once "$folder/api/emulation/MoodleEmulation.php";
require_once "$folder/api/util/StackQuestionLoader.php";
require_once "$folder/api/util/StackSeedHelper.php";
require_once "$folder/stack/cas/installhelper.class.php";

// The one function of Moodle that making Maxima's files takes, and the api folder has not.
function make_upload_directory($name) {
    global $data;
    return is_dir("$data/$name") || mkdir("$data/$name", 0700, true);
}

if (!is_readable("$data/stack/maximalocal.mac")) {
    stack_cas_configuration::create_maximalocal();
}

$questions = [];
foreach ((new SimpleXMLElement(file_get_contents($file)))->question as $each) {
    if ((string) $each['type'] === 'stack') {
        $questions[(string) $each->name->text] = '<quiz>' . $each->asXML() . '</quiz>';
    }
}
$marks = [];
foreach (json_decode(file_get_contents($attempts), true) as $each) {
    $question = \api\util\StackQuestionLoader::loadxml($questions[$each['question']])['question'];
    \api\util\StackSeedHelper::initialize_seed($question, null);
    $question->initialise_question_from_seed();
    if (!empty($question->runtimeerrors)) {
        fwrite(STDERR, implode("\n", array_keys($question->runtimeerrors)) . "\n");
        exit(1);
    }
    $question->castextprocessor = new \castext2_qa_processor(new \stack_outofcontext_process());
    $given = [];
    foreach ($each['responses'] as $response) {
        $result = $question->get_prt_result('prt1', $response, true);
        $marked = !$result->get_errors() && $question->has_necessary_prt_inputs($question->prts['prt1'], $response, true);
        $given[] = [
            'score' => $marked ? (float) $result->get_score() : null,
            'feedback' => $marked ? $result->apply_placeholder_holder($result->get_feedback()) : '',
        ];
    }
    $marks[] = $given;
}
echo json_encode(['version' => $CFG->stackmaximaversion, 'marks' => $marks]);
